#include "irsg/geometry/Entity.h"

namespace irsg {

const TemperatureEntry* temperatureEntry(const Entity& entity, int index) {
    const auto& entries = entity.database->temperatures;
    auto found = entries.find(index);
    if (found == entries.end() && entity.fallbackTemperature)
        found = entries.find(*entity.fallbackTemperature);
    return found == entries.end() ? nullptr : &found->second;
}

const Material* materialEntry(const Entity& entity, int index) {
    const auto& entries = entity.database->materials;
    auto found = entries.find(index);
    if (found == entries.end() && entity.fallbackMaterial)
        found = entries.find(*entity.fallbackMaterial);
    return found == entries.end() ? nullptr : &found->second;
}

const UserSpectrum* userSpectrumOf(const Entity& entity, const TemperatureEntry& entry) {
    if (entry.mode != EmissionMode::userSpectrum)
        return nullptr;
    const auto found = entity.database->spectra.find(entry.userSpectrum);
    return found == entity.database->spectra.end() ? nullptr : &found->second;
}

} // namespace irsg
