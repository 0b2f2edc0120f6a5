#pragma once

#include <filesystem>
#include <optional>

#include "irsg/atmosphere/Environment.h"
#include "smatcore/project/Project.h"

namespace smat {

/// Adds to `environment` what a project or a command names as its air: what openAtmosphere opens,
/// or a KARMA Environment file with its atmospheres by priority; its default background is taken
/// where the environment has none yet. Returns the sun of an Environment file, which is not set
/// here. What the files leave open or have no use for is logged. Throws InputError with the
/// offences of all files of the composition.
///
/// `resolution_cm`, 1, 5 or 15, takes the place of that of every AtmosphereSmart among them; air
/// without one has no bins and is an InputError with it.
std::optional<irsg::SunPosition> addAir(irsg::Environment& environment,
                                        const std::filesystem::path& input,
                                        std::optional<int> resolution_cm = {});

/// The sun alone of environmentOf (see SceneBuilder.h): what the settings do not set comes from the
/// first Environment file they list. Reads no other air, and throws nothing: a file that cannot be
/// read says nothing here.
irsg::SunPosition sunOf(const Project& project, const Settings& settings);

} // namespace smat
