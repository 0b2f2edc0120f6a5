#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/TabulatedAtmosphere.h"

namespace smat::batch {

/// What `smat-batch atmosphere info` tells of a file, `none` or `vacuum`: name, base, quantities
/// and remarks of the atmosphere, and by its kind
/// - of an AtmosphereSmart its parameters with value, unit and what differs from the default, and
///   the air at the ground;
/// - of a table its axes, runs and the error of interpolating between them;
/// - of homogeneous air its temperatures, of a radiative output its geometry;
/// - of an Environment sun, default background and the list of its atmospheres in the order in
///   which they are asked.
/// Both throw InputError as addAir does.
nlohmann::ordered_json atmosphereInfo(const std::filesystem::path& file);
void printAtmosphereInfo(const std::filesystem::path& file);

/// The part of that which a table alone has.
nlohmann::ordered_json tableInfo(const irsg::TabulatedAtmosphere& table);

} // namespace smat::batch
