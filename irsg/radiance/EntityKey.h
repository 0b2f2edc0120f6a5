#pragma once

#include <map>
#include <memory>
#include <optional>

#include "irsg/geometry/Entity.h"

namespace irsg {

/// What the spectra of an entity depend on beside its air and its aspect: a part of the keys of
/// what is kept of a scene.
struct EntityKey {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const SignatureDatabase> database;
    EntityState state; ///< without what follows from the geometry: altitude, ambient air, aspect
    std::optional<int> fallbackTemperature, fallbackMaterial;
    std::map<int, double> temperatureScale, emissivityScale;
    bool operator==(const EntityKey&) const = default;

    /// The same but for the state.
    bool isLike(const EntityKey& other) const {
        EntityKey own = other;
        own.state = state;
        return *this == own;
    }

    static EntityKey of(const Entity& entity) {
        EntityState state = entity.state;
        state.altitude_m = state.ambient_K = state.aspectAngle_rad = 0.0;
        return {entity.model,
                entity.database,
                state,
                entity.fallbackTemperature,
                entity.fallbackMaterial,
                entity.temperatureScale,
                entity.emissivityScale};
    }
};

} // namespace irsg
