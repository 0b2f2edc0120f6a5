#pragma once

#include <vector>

#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// Surfaces that emit and reflect each other, and no other light.
inline RenderSettings lightSettings(int bounces, double error = 0.005) {
    RenderSettings settings;
    settings.engine = EngineChoice::rays;
    settings.bounces = bounces;
    settings.lightError = error;
    settings.fluxes = ReflectionMode::off;
    settings.sun = ReflectionMode::off;
    settings.background = BackgroundMode::none;
    return settings;
}

inline Irsg rendererOf(const std::vector<Entity>& entities, const RenderSettings& settings,
                       const Environment& environment = Environment::vacuum()) {
    Irsg irsg;
    irsg.setEnvironment(environment);
    irsg.setSettings(settings);
    irsg.setEntities(entities);
    return irsg;
}

} // namespace irsg::test
