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
Triangles tilted(double angle_rad, irsg::IrCodes codes = {1, 1}) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return plateMesh({0, 0, 0}, {-1, 0, 0}, {0, -s, c}, codes);
}

/// The same at every wavelength: W m-2 um-1, and per sr of the path and of the background.
struct Air {
    double sun = 0.0, sky = 0.0, ground = 0.0;
    double transmittance = 1.0, path = 0.0, background = 0.0;
};

/// What surfaces send in the middle of the picture, W m-2 sr-1.
struct Middle {
    irsg::SignatureDatabase database = greyDatabase(0.8, 320.0);
    Air air = {};
    irsg::SunPosition sun{0.0, irsg::radians(30.0)};
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    Triangles mesh = tilted(0.0);

    double radiance(SelfTestBench& bench) const {
        ConstantAtmosphere constant;
        constant.sunValue = air.sun;
        constant.downValue = air.sky;
        constant.upValue = air.ground;
        constant.transmittanceValue = air.transmittance;
        constant.pathRadianceValue = air.path;
        constant.backgroundValue = air.background;
        InteractiveRenderer& irsg = bench.irsg();
        irsg.scene.environment = environmentOf(constant, sun);
        irsg::RenderSettings one = settings;
        one.tileSide_samples = 0;
        one.samplesPerAxis = 1;
        irsg.scene.settings = one;
        irsg.scene.entities = {entityOf(modelOf(mesh), database)};
        look(irsg, {.width_px = 5, .height_px = 5, .fieldOfView_rad = 1e-3});
        return static_cast<double>(irsg.picture().at(2, 2));
    }
};

/// A plate at several tilts, each in its own picture, and what it sends in closed form.
struct Tilts {
    std::string name, says;
    double bound;
    std::vector<double> angles_deg;
    Middle middle = {};
    double (*expected)(double angle_rad);
    std::string unit = "W m-2 sr-1";
    SelfTestCheck::Error error = relative;

    operator SelfTestCheck() const {
        const auto measure = [tilts = *this](SelfTestBench& bench) {
            const auto at = [&](double angle_deg) {
                Middle middle = tilts.middle;
                middle.mesh = tilted(irsg::radians(angle_deg));
                return SelfTestValue{middle.radiance(bench),
                                     tilts.expected(irsg::radians(angle_deg))};
            };
            return farthestOf(tilts.angles_deg, at, tilts.error);
        };
        return {name, says, unit, bound, error, measure};
    }
};

/// (1 - emissivity) / pi times the band of one W m-2 um-1, of the plate of emissivity 0.8.
constexpr double reflected_per_W_m2 = 0.2 / irsg::pi * width_um;
/// Of the plate that reflects: its emission is next to nothing.
irsg::SignatureDatabase cold() {
    return greyDatabase(0.8, 20.0);
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
    middle.air.transmittance = 0.6;
    return {middle.radiance(bench), 2.0 * 0.6 * 20.0};
}

SelfTestValue sunFromBehind(SelfTestBench& bench) {
    const auto lit = [&](const irsg::SunPosition& sun) {
        return Middle{.database = cold(), .air = {.sun = 100.0}, .sun = sun}.radiance(bench);
    };
    const double behind = lit({irsg::pi, irsg::radians(30.0)});
    return {behind + lit({0.0, irsg::radians(-20.0)}), 0.0};
}

SelfTestValue noneAndAll(SelfTestBench& bench) {
    const auto of = [&](double emissivity) {
        return Middle{.database = greyDatabase(emissivity, 320.0), .air = {.sky = 50.0}}.radiance(
            bench);
    };
    const double mirror = of(0.0);
    return {mirror + of(1.0), 25.0 * width_um / irsg::pi + black_W_m2_sr(320.0)};
}

SelfTestValue clearPane(SelfTestBench& bench) {
    const Middle middle{.database = greyDatabase(0.0, 320.0, 0.0, 1.0),
                        .air = {.sky = 50.0, .path = 0.25, .background = 0.9}};
    return {middle.radiance(bench), 0.9 * width_um};
}

SelfTestValue sunAtTheZenith(SelfTestBench& bench) {
    return farthestOf({90.0, 1.0}, [&](double elevation_deg) {
        const Middle middle{.database = cold(),
                            .air = {.sun = 100.0},
                            .sun = {0.0, irsg::radians(elevation_deg)},
                            .mesh = tilted(irsg::radians(60.0))};
        return SelfTestValue{middle.radiance(bench),
                             reflected_per_W_m2 * 100.0 *
                                 std::cos(irsg::radians(60.0 - elevation_deg))};
    });
}

} // namespace

std::vector<SelfTestCheck> surfaceChecks() {
    return withHard(
        {
            Tilts{.name = "surface.emission",
                  .says =
                      "Emission of a grey plate that is seen at 0 to 70 degrees: emissivity times "
                      "a black body",
                  .bound = 1e-6,
                  .angles_deg = {0.0, 30.0, 70.0},
                  .expected = [](double) { return 0.8 * black_W_m2_sr(320.0); }},
            Tilts{.name = "surface.angle-factor",
                  .says = "With N = 3 and at 0 to 70 degrees: times the third power of the cosine",
                  .bound = 2e-6,
                  .angles_deg = {0.0, 30.0, 70.0},
                  .middle = {.database = greyDatabase(0.8, 320.0, 3.0)},
                  .expected =
                      [](double angle) {
                          return 0.8 * black_W_m2_sr(320.0) * std::pow(std::cos(angle), 3.0);
                      }},
            Tilts{.name = "surface.transmittance",
                  .says = "Emission through air of transmittance 0.6, with a path radiance",
                  .bound = 1e-6,
                  .angles_deg = {0.0, 45.0},
                  .middle = {.air = {.transmittance = 0.6, .path = 0.25}},
                  .expected =
                      [](double) { return 0.6 * 0.8 * black_W_m2_sr(320.0) + 0.25 * width_um; }},
            Tilts{.name = "surface.sun",
                  .says =
                      "Sun of 30 degrees on plates of four tilts: reflectivity / pi, irradiance, "
                      "cosine and transmittance",
                  .bound = 2e-6,
                  .angles_deg = {0.0, 20.0, 60.0, -40.0},
                  .middle = {.database = cold(), .air = {.sun = 100.0, .transmittance = 0.6}},
                  .expected =
                      [](double angle) {
                          return reflected_per_W_m2 * 0.6 * 100.0 *
                                 std::cos(angle - irsg::radians(30.0));
                      }},
            {"surface.sun-from-behind",
             "A sun behind the plate, and one below the horizon, light nothing that is seen",
             "W m-2 sr-1", 1e-9, absolute, sunFromBehind},
            Tilts{.name = "surface.sky",
                  .says =
                      "Light of the sky on plates of four tilts: view factor (1 + sin tilt) / 2",
                  .bound = 2e-6,
                  .angles_deg = {0.0, 25.0, 70.0, -50.0},
                  .middle = {.database = cold(), .air = {.sky = 50.0}},
                  .expected =
                      [](double angle) {
                          return reflected_per_W_m2 * 50.0 * 0.5 * (1.0 + std::sin(angle));
                      }},
            Tilts{.name = "surface.ground",
                  .says = "Light of the ground likewise: view factor (1 - sin tilt) / 2",
                  .bound = 4e-6, // at 70 deg the factor loses one digit of a float
                  .angles_deg = {0.0, 25.0, 70.0, -50.0},
                  .middle = {.database = cold(), .air = {.ground = 50.0}},
                  .expected =
                      [](double angle) {
                          return reflected_per_W_m2 * 50.0 * 0.5 * (1.0 - std::sin(angle));
                      }},
            Tilts{.name = "surface.report-weights",
                  .says = "Light of the sky with the weights of the report: 1 - zenith angle / pi",
                  .bound = 2e-6,
                  .angles_deg = {0.0, 25.0, 70.0, -50.0},
                  .middle = {.database = cold(),
                             .air = {.sky = 50.0},
                             .settings = {.fluxWeights = irsg::FluxWeights::report,
                                          .skybox = {},
                                          .terrain = {}}},
                  .expected =
                      [](double angle) {
                          const double zenith = 0.5 * irsg::pi - angle;
                          return reflected_per_W_m2 * 50.0 * (1.0 - zenith / irsg::pi);
                      }},
            Tilts{.name = "surface.approx",
                  .says = "Sun, sky and ground in the mode approx: a quarter, a half and a half, "
                          "however the plate is tilted",
                  .bound = 2e-6,
                  .angles_deg = {0.0, 60.0},
                  .middle = {.database = cold(),
                             .air = {.sun = 100.0, .sky = 50.0, .ground = 30.0},
                             .settings = {.sun = irsg::ReflectionMode::approx,
                                          .ambientReflection = irsg::ReflectionMode::approx,
                                          .skybox = {},
                                          .terrain = {}}},
                  .expected = [](double) { return reflected_per_W_m2 * (25.0 + 25.0 + 15.0); }},
            Tilts{.name = "surface.glass-before-sky",
                  .says =
                      "A warm pane of emissivity 0.3 and transmissivity 0.6: emission, reflected "
                      "sky, its part of the path and of the background",
                  .bound = 2e-6,
                  .angles_deg = {0.0},
                  .middle =
                      {.database = greyDatabase(0.3, 320.0, 0.0, 0.6),
                       .air = {.sky = 50.0, .transmittance = 0.7, .path = 0.25, .background = 0.9}},
                  .expected =
                      [](double) {
                          return 0.7 * (0.3 * black_W_m2_sr(320.0) +
                                        0.1 / irsg::pi * width_um * 25.0) +
                                 0.4 * 0.25 * width_um + 0.6 * 0.9 * width_um;
                      }},
            {"surface.gas-before-body",
             "A body of 700 K behind a gas of 400 K whose bands change over the sensor's: products "
             "at each wavelength, against Simpson's rule",
             "W m-2 sr-1", 1e-5, relative, gasBeforeBody},
            {"surface.measured-spectrum",
             "A measured spectrum with its calibration factor through air, by hand", "W m-2 sr-1",
             1e-6, relative, measuredSpectrum},
        },
        {
            {"surface.emissivity-0-and-1",
             "Emissivity 0 emits nothing, 1 a black body and reflects nothing", "W m-2 sr-1", 1e-6,
             relative, noneAndAll},
            {"surface.clear-pane", "A pane of transmissivity 1 before the sky is not there",
             "W m-2 sr-1", 1e-6, relative, clearPane},
            Tilts{.name = "surface.angle-factor-50",
                  .says = "N = 50 at 0, 30 and 80 degrees: the power of the cosine, relative to "
                          "the front",
                  .bound = 1e-5,
                  .angles_deg = {0.0, 30.0, 80.0},
                  .middle = {.database = greyDatabase(1.0 / black_W_m2_sr(700.0), 700.0, 50.0)},
                  .expected = [](double angle) { return std::pow(std::cos(angle), 50.0); },
                  .unit = "",
                  .error = absolute},
            {"surface.sun-at-the-zenith",
             "A sun in the zenith on a plate that looks up by 60 degrees, and on the horizon",
             "W m-2 sr-1", 2e-6, relative, sunAtTheZenith},
        });
}

} // namespace smat::selftest
