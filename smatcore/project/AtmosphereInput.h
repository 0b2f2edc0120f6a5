#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "irsg/atmosphere/Atmosphere.h"

namespace smat {

/// True for `none` and `vacuum`, which are words, not files.
bool isNoAir(const std::filesystem::path& input);

/// What a project or a command names as its air: those words, or a file of any kind that
/// irsg::loadAtmosphere knows. Throws InputError for a file that is missing, is no atmosphere or
/// is damaged.
///
/// `resolution_cm`, 1, 5 or 15, takes the place of an AtmosphereSmart's own; other air has no bins
/// and is an InputError with it.
std::shared_ptr<const irsg::Atmosphere> openAtmosphere(const std::filesystem::path& input,
                                                       std::optional<int> resolution_cm = {});

} // namespace smat
