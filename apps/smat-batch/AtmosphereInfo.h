#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/Atmosphere.h"

namespace smat::batch {

/// What `smat-batch atmosphere info` tells of a file, `none` or `vacuum`: name, base, quantities
/// and remarks of the atmosphere and what it tells of itself (Atmosphere::describe); of an
/// Environment sun, default background and the list of its atmospheres in the order in which they
/// are asked.
/// Both throw InputError as addAtmosphere does.
nlohmann::ordered_json atmosphereInfo(const std::filesystem::path& file);
void printAtmosphereInfo(const std::filesystem::path& file);

/// What an atmosphere tells of itself.
nlohmann::ordered_json factsOf(const irsg::Atmosphere& atmosphere);

} // namespace smat::batch
