#include "tests/support/WidebandScenes.h"

#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg::test {

namespace {

const IrCodes one{1, 1}, two{2, 2};

} // namespace

std::shared_ptr<AtmosphereSmart> smartAtmosphere(int model, double min_um, double max_um,
                                                 int scattering, int resolution_per_cm) {
    AtmosphereSmartParameters parameters;
    parameters.atmosphereModel = model;
    parameters.baseWavelengthMin_um = min_um;
    parameters.baseWavelengthMax_um = max_um;
    parameters.scatteringMode = scattering;
    parameters.resolution_per_cm = resolution_per_cm;
    parameters.irradianceMode = 2;
    return std::make_shared<AtmosphereSmart>(parameters);
}

Environment environmentOf(std::shared_ptr<const Atmosphere> atmosphere) {
    Environment environment;
    environment.sun = {1.0, 0.6};
    environment.add(std::move(atmosphere));
    return environment;
}

Spectrum hotGas() {
    std::vector<double> wavelengths_um, radiance;
    for (double nu = 2420.0; nu >= 2080.0; nu -= 0.4) {
        const double envelope = std::exp(-std::pow((nu - 2290.0) / 70.0, 2.0));
        const double depth = 2.0 * envelope * (1.0 + 0.9 * std::cos(2.0 * pi * nu / 1.6));
        wavelengths_um.push_back(1e4 / nu);
        radiance.push_back(-std::expm1(-depth) * planckRadiance_W_m2_sr_um(1e4 / nu, 1200.0));
    }
    return Spectrum(wavelengths_um, radiance, Spectrum::Outside::zero, "gas");
}

SignatureDatabase painted(const Band& band, double temperature_K) {
    SignatureDatabase database = greyDatabase(0.8, temperature_K);
    database.temperatures[2] = fixedTemperature(temperature_K + 40.0);
    const double a = band.range().min_um, c = band.range().centre_um(), b = band.range().max_um;
    database.materials[2].emissivity = Spectrum({a, c - 0.05, c + 0.05, b}, {0.9, 0.7, 0.3, 0.5});
    return database;
}

SignatureDatabase withGas(double reference_m) {
    SignatureDatabase database = greyDatabase(0.9, 320.0);
    TemperatureEntry& entry = database.temperatures[2];
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "gas";
    database.materials[2] = greyMaterial(1.0);
    database.spectra["gas"] = {"gas", reference_m, "W m-2 sr-1 um-1", "", {{"CO2", hotGas()}}};
    return database;
}

std::shared_ptr<const Model> ball() {
    static const auto model = modelOf(sphereMesh(1.0, 16, 32, one));
    return model;
}
std::shared_ptr<const Model> box() {
    static const auto model = modelOf(boxMesh({1, 2, 1}, {one, two, one, two, one, two}));
    return model;
}

Environment WidebandAtmosphere::environment(int resolution_per_cm) const {
    return environmentOf(smartAtmosphere(model, min_um, max_um, 2, resolution_per_cm));
}

std::vector<WidebandAtmosphere> widebandAtmospheres() {
    return {{"TropicalMidwave", 1, 3.0, 5.0},
            {"SubarcticMidwave", 5, 3.4, 4.8},
            {"StandardLongwave", 6, 8.0, 12.0},
            {"SummerShortwave", 2, 2.0, 2.5}};
}

std::vector<WidebandScene> widebandScenes(const Band& band) {
    std::vector<WidebandScene> scenes{
        {"sphere, level", entityOf(ball(), painted(band, 290.0)), {.range_m = 500.0}},
        {"sphere, far", entityOf(ball(), painted(band, 600.0)), {.range_m = 12e3}},
        {"box, from above",
         entityOf(box(), painted(band, 310.0)),
         {.range_m = 3000.0, .azimuth_rad = 0.7, .elevation_rad = 0.9}},
        {"box, from below",
         entityOf(box(), painted(band, 330.0)),
         {.range_m = 1500.0, .azimuth_rad = 2.0, .elevation_rad = -0.5}},
        {"box with gas",
         entityOf(box(), withGas(200.0)),
         {.range_m = 4000.0, .azimuth_rad = 1.2, .elevation_rad = 0.3}}};
    for (WidebandScene& scene : scenes) {
        scene.view.band = band;
        scene.view.fieldOfView_rad = 6.0 / scene.view.range_m;
    }
    return scenes;
}

} // namespace irsg::test
