#pragma once

#include <filesystem>
#include <optional>

#include "irsg/atmosphere/Environment.h"

namespace smat {

/// Adds to `environment` what a project names as its air: what openAtmosphere opens, or a KARMA
/// Environment file with its atmospheres by priority; its default background is taken where the
/// environment has none yet. Returns the sun of an Environment file, which is not set here. What
/// the files leave open or have no use for is logged. Throws InputError with the offences of all
/// files of the composition.
std::optional<irsg::SunPosition> addAir(irsg::Environment& environment,
                                        const std::filesystem::path& input);

} // namespace smat
