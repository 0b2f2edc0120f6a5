#pragma once

#include <filesystem>
#include <memory>

#include "irsg/atmosphere/Atmosphere.h"

namespace smat {

/// True for `none` and `vacuum`, which are words, not files.
bool isNoAtmosphere(const std::filesystem::path& input);

/// One atmosphere that a project or a command names: those words, or a file of any kind that
/// irsg::loadAtmosphere knows. Throws InputError for a file that is missing, is no atmosphere or
/// is damaged.
std::shared_ptr<const irsg::Atmosphere> openAtmosphere(const std::filesystem::path& input);

} // namespace smat
