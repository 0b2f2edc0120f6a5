#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// One thing that flies, drives or floats.
struct Entity {
    std::string name;
    std::shared_ptr<const Model> model;
    std::shared_ptr<const SignatureDatabase> database;
    Pose pose;
    /// Altitude, ambient temperature and aspect angle are filled in by the renderer.
    EntityState state;
    /// Other states of the same sweep, of each entity as many: drawings serve all of them, as hot
    /// parts are those of any (HotSpotSurfaces).
    std::vector<EntityState> otherStates;
    /// In model axes; the centre of the bounding box of the opaque geometry where it is not set.
    std::optional<Vec3> referencePoint_m;
    /// Entries that stand in for codes without one; otherwise such a face is an InputError.
    std::optional<int> fallbackTemperature;
    std::optional<int> fallbackMaterial;
    /// Scalings (report section 11): T in K is multiplied, emissivity is multiplied.
    std::map<int, double> temperatureScale;
    std::map<int, double> emissivityScale;
};

/// The entry or material behind a code, with the entity's fallback; null where there is none.
const TemperatureEntry* temperatureEntry(const Entity& entity, int index);
const Material* materialEntry(const Entity& entity, int index);
/// The spectrum of an entry in the second mode; null for one that has a temperature.
const UserSpectrum* userSpectrumOf(const Entity& entity, const TemperatureEntry& entry);

} // namespace irsg
