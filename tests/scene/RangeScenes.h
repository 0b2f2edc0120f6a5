#pragma once

#include <utility>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

/// What tests of curves and searches over the range look at.
namespace irsg::test::ranges {

inline constexpr IrCodes one{1, 1};
inline constexpr double emissivity = 0.9, temperature_K = 320.0;

inline RenderSettings settingsOf(int tileSide_samples) {
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = tileSide_samples;
    settings.background = BackgroundMode::constant;
    settings.background_W_m2_sr = 0.5;
    return settings;
}

inline Entity grey(const Triangles& mesh) {
    return entityOf(modelOf(mesh), greyDatabase(emissivity, temperature_K));
}

inline InteractiveRenderer generatorOf(std::vector<Entity> entities, int tileSide_samples = 256) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.settings = settingsOf(tileSide_samples);
    irsg.scene.entities = std::move(entities);
    return irsg;
}

struct Aspect {
    double azimuth_deg = 0.0, elevation_deg = 0.0;
};

inline void look(InteractiveRenderer& irsg, const Aspect& aspect, double range_m) {
    test::look(irsg, {.range_m = range_m,
                      .azimuth_rad = radians(aspect.azimuth_deg),
                      .elevation_rad = radians(aspect.elevation_deg),
                      .width_px = 400,
                      .height_px = 300,
                      .fieldOfView_rad = 0.2});
}

} // namespace irsg::test::ranges
