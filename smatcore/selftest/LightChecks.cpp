// Light that goes from surface to surface, and shadows: by rays.
#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/Scenes.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using namespace irsg::reference;
using irsg::InteractiveRenderer;

void needRays() {
    if (!irsg::areRaysBuilt())
        throw irsg::InputError(irsg::Diagnostic{.file = "this build",
                                                .position = "",
                                                .value = irsg::whyNoRays(),
                                                .expected = "rays (Embree)"});
}

irsg::RenderSettings lit(int bounces) {
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    settings.engine = irsg::EngineChoice::rays;
    settings.bounces = bounces;
    settings.ambientReflection = irsg::ReflectionMode::off;
    settings.background = irsg::BackgroundMode::none;
    return settings;
}

/// Inside a closed grey box of one temperature, everything is black.
SelfTestValue enclosure(SelfTestBench& bench) {
    needRays();
    InteractiveRenderer& irsg = bench.irsg();
    irsg::RenderSettings settings = lit(irsg::convergedBounces);
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    irsg.scene.entities = {
        entityOf(modelOf(boxMesh({2, 3, 1}, std::vector<irsg::IrCodes>(6, {1, 1}))),
                 greyDatabase(0.4, 350.0))};
    look(irsg, {.range_m = 0.5, .width_px = 16, .height_px = 16, .fieldOfView_rad = 1.2});
    const irsg::RadianceImage image = irsg.picture();
    const double black = irsg::bandRadiance_W_m2_sr(band, 350.0);
    Farthest farthest;
    for (const float value : image.primary().values)
        farthest.add(static_cast<double>(value), black);
    return farthest.found();
}

/// A view factor from perpendicular unit squares that share an edge, by what a cold one reflects
/// of a hot one: F = 0.20004 (Howell, C-14, h = w = 1).
SelfTestValue perpendicularSquares(SelfTestBench& bench) {
    needRays();
    InteractiveRenderer& irsg = bench.irsg();
    irsg::RenderSettings settings = lit(1);
    settings.lightError = 5e-4;
    irsg.scene.settings = settings;
    irsg::SignatureDatabase database = greyDatabase(1.0, 600.0);
    database.temperatures[2] = fixedTemperature(20.0);
    database.materials[2] = greyMaterial(0.5);
    // The hot one looks up, the cold one along +y; from far behind the hot one's edge and level
    // with it the cold one alone is seen.
    const Triangles hot = oneSidedPlate({0, 0.5, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1});
    const Triangles cold = oneSidedPlate({0, 0, 0.5}, {-0.5, 0, 0}, {0, 0, 0.5}, {2, 2});
    irsg.scene.entities = {entityOf(modelOf(joined(hot, cold)), database)};
    look(irsg, {.range_m = 5000.0, .fieldOfView_rad = 1e-3});
    const double logs = std::log(4.0 / 3.0) + 2.0 * std::log(3.0 / 4.0);
    const double factor =
        (2.0 * std::atan(1.0) - std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) + 0.25 * logs) /
        irsg::pi;
    return {irsg.measure().all.intensity_W_sr,
            0.5 * factor * irsg::bandRadiance_W_m2_sr(band, 600.0)};
}

/// The sun at 40 degrees upon a floor below a smaller plate, seen from the other side: the floor
/// less the shadow and less what the plate hides, each as large as the plate, which do not meet.
SelfTestValue shadow(SelfTestBench& bench) {
    needRays();
    InteractiveRenderer& irsg = bench.irsg();
    ConstantAtmosphere air;
    air.sunValue = 100.0;
    const irsg::SunPosition sun{0.8, irsg::radians(40.0)};
    irsg.scene.environment = environmentOf(air, sun);
    irsg::RenderSettings settings = lit(0);
    settings.sunShadows = irsg::SunShadowMode::point;
    irsg.scene.settings = settings;
    irsg::SignatureDatabase database = greyDatabase(0.8, 20.0);
    database.temperatures[2] = fixedTemperature(20.0);
    database.materials[2] = greyMaterial(1.0);
    const Triangles floor = oneSidedPlate({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1});
    const Triangles roof = plateMesh({0, 0, 1.0}, {0.5, 0, 0}, {0, 0.5, 0}, {2, 2});
    irsg.scene.entities = {entityOf(modelOf(joined(floor, roof)), database)};
    look(irsg, {.range_m = 5000.0,
                .azimuth_rad = 0.8 + irsg::pi,
                .elevation_rad = irsg::radians(60.0),
                .fieldOfView_rad = 2e-3});
    const double lit_m2 = 16.0 - 1.0 - 1.0;
    return {irsg.measure().all.intensity_W_sr, 0.2 / irsg::pi * 2.0 * 100.0 *
                                                   std::sin(irsg::radians(40.0)) * lit_m2 *
                                                   std::sin(irsg::radians(60.0))};
}

} // namespace

std::vector<SelfTestCheck> lightChecks() {
    return {
        {"light.enclosure",
         "Inside a closed grey box of one temperature, with all reflections: a black body in every "
         "pixel",
         "W m-2 sr-1", 2e-3, relative, enclosure},
        {"light.perpendicular-squares",
         "What a square reflects of a hot one at its edge: view factor C-14 of Howell's catalogue",
         "W sr-1", 5e-3, relative, perpendicularSquares},
        {"light.shadow", "A floor in the sun less the shadow of a plate of 1 m2 above it", "W sr-1",
         5e-3, relative, shadow},
    };
}

} // namespace smat::selftest
