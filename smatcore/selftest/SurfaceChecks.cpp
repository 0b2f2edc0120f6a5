// What one surface sends, term by term, in a picture of one plate.
#include <cmath>
#include <functional>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/reference/Scenes.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using namespace irsg::reference;
using irsg::InteractiveRenderer;
using irsg::Spectrum;
using irsg::Vec3;

constexpr double width_um = 2.0;

double black_W_m2_sr(double temperature_K) {
    return static_cast<double>(irsg::reference::bandRadiance(band.range(), temperature_K));
}

/// A plate through the origin whose front looks along (0, cos, sin) of an angle above the nose,
/// which the camera stands before.
Mesh tilted(double angle_rad, irsg::IrCodes codes = {1, 1}) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return plateMesh({0, 0, 0}, {-1, 0, 0}, {0, -s, c}, codes);
}

/// What surfaces send in the middle of the picture, W m-2 sr-1.
struct Middle {
    Mesh mesh = tilted(0.0);
    irsg::SignatureDatabase database = greyDatabase(0.8, 320.0);
    ConstantAtmosphere air;
    irsg::SunPosition sun{0.0, irsg::radians(30.0)};
    irsg::RenderSettings settings;
    double range_m = 100.0;

    double radiance(SelfTestBench& bench) const {
        InteractiveRenderer& irsg = bench.irsg();
        irsg.scene.environment = environmentOf(air, sun);
        irsg::RenderSettings one = settings;
        one.tileSide_samples = 0;
        one.samplesPerAxis = 1;
        irsg.scene.settings = one;
        irsg.scene.entities = {entityOf(modelOf(mesh), database)};
        look(irsg, {.range_m = range_m, .width_px = 5, .height_px = 5, .fieldOfView_rad = 1e-3});
        return static_cast<double>(irsg.picture().at(2, 2));
    }
};

SelfTestValue tilts(SelfTestBench& bench, const std::function<void(Middle&)>& set,
                    const std::function<double(double)>& expected,
                    const std::vector<double>& angles_deg, SelfTestCheck::Error error = relative) {
    Farthest farthest(error);
    for (const double angle_deg : angles_deg) {
        Middle middle;
        middle.mesh = tilted(irsg::radians(angle_deg));
        set(middle);
        farthest.add(middle.radiance(bench), expected(irsg::radians(angle_deg)));
    }
    return farthest.found();
}

/// (1 - emissivity) / pi times the band of one W m-2 um-1, of the plate of emissivity 0.8.
constexpr double reflected_per_W_m2 = 0.2 / irsg::pi * width_um;
/// Emission of the cold plate that reflects, which is next to nothing.
void cold(Middle& middle) {
    middle.database = greyDatabase(0.8, 20.0);
}

/// A gas whose transmissivity falls from 1 to 0 and rises again over the band, before a black body:
/// its emission, and what it lets through, multiplied at each wavelength.
SelfTestValue gasBeforeBody(SelfTestBench& bench) {
    const Spectrum through({3.0, 4.0, 5.0}, {1.0, 0.0, 1.0});
    Middle middle;
    middle.mesh = joined(plateMesh({0, -1, 0}, {-1, 0, 0}, {0, 0, 1}, {1, 1}),
                         plateMesh({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {2, 2}));
    middle.database = greyDatabase(1.0, 700.0);
    middle.database.temperatures[2] = fixedTemperature(400.0);
    irsg::Material gas = greyMaterial(0.0);
    gas.transmissivity = through;
    gas.emissivity = Spectrum({3.0, 4.0, 5.0}, {0.0, 1.0, 0.0});
    middle.database.materials[2] = gas;

    // The air lets through what the gas does: products of three spectra.
    constexpr int intervals = 40000;
    long double sum = 0.0L;
    for (int i = 0; i <= intervals; ++i) {
        const long double um = 3.0L + 2.0L * i / intervals, t = std::abs(um - 4.0L);
        const int weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight * (t * irsg::reference::planck(um, 700.0L) +
                         (1.0L - t) * irsg::reference::planck(um, 400.0L));
    }
    return {middle.radiance(bench), static_cast<double>(sum * 2.0L / intervals / 3.0L)};
}

/// A measured spectrum of one component, twice its curve by the calibration factor, through air.
SelfTestValue measuredSpectrum(SelfTestBench& bench) {
    Middle middle;
    auto& entry = middle.database.temperatures[1];
    entry.mode = irsg::EmissionMode::userSpectrum;
    entry.userSpectrum = "flame";
    irsg::UserSpectrum flame;
    flame.name = "flame";
    flame.components = {{"all", Spectrum({3.5, 4.5}, {10.0, 30.0}, Spectrum::Outside::zero)}};
    flame.calibrationFactor = 2.0;
    middle.database.spectra["flame"] = flame;
    middle.air.transmittanceValue = 0.6;
    return {middle.radiance(bench), 2.0 * 0.6 * 20.0};
}

} // namespace

std::vector<SelfTestCheck> surfaceChecks() {
    return {
        {.name = "surface.emission",
         .says = "Emission of a grey plate that is seen at 0 to 70 degrees: emissivity times a "
                 "black body",
         .unit = "W m-2 sr-1",
         .bound = 1e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench, [](Middle&) {}, [](double) { return 0.8 * black_W_m2_sr(320.0); },
                     {0.0, 30.0, 70.0});
             }},
        {.name = "surface.angle-factor",
         .says = "With N = 3 and at 0 to 70 degrees: times the third power of the cosine",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench, [](Middle& middle) { middle.database = greyDatabase(0.8, 320.0, 3.0); },
                     [](double angle) {
                         return 0.8 * black_W_m2_sr(320.0) * std::pow(std::cos(angle), 3.0);
                     },
                     {0.0, 30.0, 70.0});
             }},
        {.name = "surface.transmittance",
         .says = "Emission through air of transmittance 0.6, with a path radiance",
         .unit = "W m-2 sr-1",
         .bound = 1e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         middle.air.transmittanceValue = 0.6;
                         middle.air.pathRadianceValue = 0.25;
                     },
                     [](double) { return 0.6 * 0.8 * black_W_m2_sr(320.0) + 0.25 * width_um; },
                     {0.0, 45.0});
             }},
        {.name = "surface.sun",
         .says = "Sun of 30 degrees on plates of four tilts: reflectivity / pi, irradiance, cosine "
                 "and transmittance",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         cold(middle);
                         middle.air.sunValue = 100.0;
                         middle.air.transmittanceValue = 0.6;
                     },
                     [](double angle) {
                         return reflected_per_W_m2 * 0.6 * 100.0 *
                                std::cos(angle - irsg::radians(30.0));
                     },
                     {0.0, 20.0, 60.0, -40.0});
             }},
        {.name = "surface.sun-from-behind",
         .says = "A sun behind the plate, and one below the horizon, light nothing that is seen",
         .unit = "W m-2 sr-1",
         .bound = 1e-9,
         .error = absolute,
         .measure =
             [](auto& bench) {
                 Middle middle;
                 cold(middle);
                 middle.air.sunValue = 100.0;
                 middle.sun.azimuth_rad = irsg::pi;
                 const double behind = middle.radiance(bench);
                 middle.sun = {0.0, irsg::radians(-20.0)};
                 return SelfTestValue{behind + middle.radiance(bench), 0.0};
             }},
        {.name = "surface.sky",
         .says = "Light of the sky on plates of four tilts: view factor (1 + sin tilt) / 2",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         cold(middle);
                         middle.air.downValue = 50.0;
                     },
                     [](double angle) {
                         return reflected_per_W_m2 * 50.0 * 0.5 * (1.0 + std::sin(angle));
                     },
                     {0.0, 25.0, 70.0, -50.0});
             }},
        {.name = "surface.ground",
         .says = "Light of the ground likewise: view factor (1 - sin tilt) / 2",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         cold(middle);
                         middle.air.upValue = 50.0;
                     },
                     [](double angle) {
                         return reflected_per_W_m2 * 50.0 * 0.5 * (1.0 - std::sin(angle));
                     },
                     {0.0, 25.0, 70.0, -50.0});
             }},
        {.name = "surface.report-weights",
         .says = "Light of the sky with the weights of the report: 1 - zenith angle / pi",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         cold(middle);
                         middle.air.downValue = 50.0;
                         middle.settings.fluxWeights = irsg::FluxWeights::report;
                     },
                     [](double angle) {
                         const double zenith = 0.5 * irsg::pi - angle;
                         return reflected_per_W_m2 * 50.0 * (1.0 - zenith / irsg::pi);
                     },
                     {0.0, 25.0, 70.0, -50.0});
             }},
        {.name = "surface.approx",
         .says = "Sun, sky and ground in the mode approx: a quarter, a half and a half, however "
                 "the plate is tilted",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         cold(middle);
                         middle.air.sunValue = 100.0;
                         middle.air.downValue = 50.0;
                         middle.air.upValue = 30.0;
                         middle.settings.sun = irsg::ReflectionMode::approx;
                         middle.settings.ambientReflection = irsg::ReflectionMode::approx;
                     },
                     [](double) { return reflected_per_W_m2 * (25.0 + 25.0 + 15.0); }, {0.0, 60.0});
             }},
        {.name = "surface.glass-before-sky",
         .says = "A warm pane of emissivity 0.3 and transmissivity 0.6: emission, reflected sky, "
                 "its part of the path and of the background",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         middle.database = greyDatabase(0.3, 320.0, 0.0, 0.6);
                         middle.air.transmittanceValue = 0.7;
                         middle.air.pathRadianceValue = 0.25;
                         middle.air.backgroundValue = 0.9;
                         middle.air.downValue = 50.0;
                     },
                     [](double) {
                         return 0.7 * (0.3 * black_W_m2_sr(320.0) +
                                       0.1 / irsg::pi * width_um * 25.0) +
                                0.4 * 0.25 * width_um + 0.6 * 0.9 * width_um;
                     },
                     {0.0});
             }},
        {.name = "surface.gas-before-body",
         .says = "A body of 700 K behind a gas of 400 K whose bands change over the sensor's: "
                 "products at each wavelength, against Simpson's rule",
         .unit = "W m-2 sr-1",
         .bound = 1e-5,
         .measure = [](auto& bench) { return gasBeforeBody(bench); }},
        {.name = "surface.measured-spectrum",
         .says = "A measured spectrum with its calibration factor through air, by hand",
         .unit = "W m-2 sr-1",
         .bound = 1e-6,
         .measure = [](auto& bench) { return measuredSpectrum(bench); }},
        {.name = "surface.emissivity-0-and-1",
         .says = "Emissivity 0 emits nothing, 1 a black body and reflects nothing",
         .unit = "W m-2 sr-1",
         .bound = 1e-6,
         .hard = true,
         .measure =
             [](auto& bench) {
                 Middle middle;
                 middle.air.downValue = 50.0;
                 middle.database = greyDatabase(0.0, 320.0);
                 const double mirror = middle.radiance(bench);
                 middle.database = greyDatabase(1.0, 320.0);
                 return SelfTestValue{mirror + middle.radiance(bench),
                                      25.0 * width_um / irsg::pi + black_W_m2_sr(320.0)};
             }},
        {.name = "surface.clear-pane",
         .says = "A pane of transmissivity 1 before the sky is not there",
         .unit = "W m-2 sr-1",
         .bound = 1e-6,
         .hard = true,
         .measure =
             [](auto& bench) {
                 Middle middle;
                 middle.database = greyDatabase(0.0, 320.0, 0.0, 1.0);
                 middle.air.backgroundValue = 0.9;
                 middle.air.pathRadianceValue = 0.25;
                 middle.air.downValue = 50.0;
                 return SelfTestValue{middle.radiance(bench), 0.9 * width_um};
             }},
        {.name = "surface.angle-factor-50",
         .says = "N = 50 at 0, 30 and 80 degrees: the power of the cosine, relative to the front",
         .unit = "",
         .bound = 1e-5,
         .error = absolute,
         .hard = true,
         .measure =
             [](auto& bench) {
                 return tilts(
                     bench,
                     [](Middle& middle) {
                         middle.database = greyDatabase(1.0 / black_W_m2_sr(700.0), 700.0, 50.0);
                     },
                     [](double angle) { return std::pow(std::cos(angle), 50.0); },
                     {0.0, 30.0, 80.0}, absolute);
             }},
        {.name = "surface.sun-at-the-zenith",
         .says = "A sun in the zenith on a plate that looks up by 60 degrees, and on the horizon",
         .unit = "W m-2 sr-1",
         .bound = 2e-6,
         .hard = true,
         .measure =
             [](auto& bench) {
                 Farthest farthest;
                 for (const double elevation_deg : {90.0, 1.0}) {
                     Middle middle;
                     cold(middle);
                     middle.mesh = tilted(irsg::radians(60.0));
                     middle.air.sunValue = 100.0;
                     middle.sun.elevation_rad = irsg::radians(elevation_deg);
                     farthest.add(middle.radiance(bench),
                                  reflected_per_W_m2 * 100.0 *
                                      std::cos(irsg::radians(60.0 - elevation_deg)));
                 }
                 return farthest.found();
             }},
    };
}

} // namespace smat::selftest
