#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// Surfaces that emit and reflect each other, and no other light.
inline RenderSettings lightSettings(int bounces, double error = 0.005) {
    RenderSettings settings = RenderSettings::direct();
    settings.engine = EngineChoice::rays;
    settings.bounces = bounces;
    settings.lightError = error;
    settings.ambientReflection = ReflectionMode::off;
    settings.sun = ReflectionMode::off;
    settings.background = BackgroundMode::none;
    return settings;
}

inline InteractiveRenderer rendererOf(const std::vector<Entity>& entities,
                                      const RenderSettings& settings,
                                      const Environment& environment = Environment::vacuum()) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environment;
    irsg.scene.settings = settings;
    irsg.scene.entities = entities;
    return irsg;
}

/// What a camera in a closed room of 2 x 1.5 x 1 m about its origin sees in 3 to 5 um, pixel by
/// pixel.
inline std::vector<double> pixelsInRoom(const Entity& room, int bounces, double error) {
    InteractiveRenderer irsg = rendererOf({room}, lightSettings(bounces, error));
    Sensor sensor = sensorOf(24, 20, 100.0);
    sensor.band = Band::topHat(3.0, 5.0);
    irsg.view.sensor = sensor;
    const Vec3 eye{1.6, 1.1, standingAltitude_m + 0.6};
    irsg.view.viewpoint = Viewpoint::lookAt(eye, eye + Vec3{-std::cos(0.6), -std::sin(0.6), -0.2});
    const RadianceImage image = irsg.imageWithReport().image;
    const std::vector<float>& values = image.find("L")->values;
    return {values.begin(), values.end()};
}

/// The least and the greatest ratio of one's pixels to another's.
inline std::pair<double, double> ratiosOf(const std::vector<double>& one,
                                          const std::vector<double>& other) {
    std::pair<double, double> found{one.at(0) / other.at(0), one.at(0) / other.at(0)};
    for (std::size_t p = 0; p < one.size(); ++p) {
        found.first = std::min(found.first, one[p] / other.at(p));
        found.second = std::max(found.second, one[p] / other.at(p));
    }
    return found;
}

} // namespace irsg::test
