#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "smatcore/project/Project.h"

namespace smat {

/// Adds to `environment` what a project or a command names as its air, in that order: of each what
/// openAtmosphere opens, or a KARMA Environment file with its atmospheres by priority; the first
/// default background of a file is taken where the environment has none yet. Returns the sun of the
/// first Environment file, which is not set here. What the files leave open or have no use for is
/// logged. Throws InputError with the diagnostics of all files.
///
/// `resolution_per_cm`, 1, 5 or 15, takes the place of that of every AtmosphereSmart among them;
/// air without one has no bins and is an InputError with it.
std::optional<irsg::SunPosition> addAtmosphere(irsg::Environment& environment,
                                               const std::vector<std::filesystem::path>& inputs,
                                               std::optional<int> resolution_per_cm = {});

/// What the settings list as atmospheres, with paths that hold anywhere; words (see isNoAtmosphere)
/// stay.
std::vector<std::filesystem::path> resolvedAtmosphere(const Project& project,
                                                      const Settings& settings);

/// Gives `sun` the azimuth and elevation that the settings set; what they do not set stays.
void moveSun(irsg::SunPosition& sun, const Settings& settings);

/// The sun alone of environmentOf (see SceneBuilder.h): what the settings do not set comes from the
/// first Environment file they list. Reads no other air, and throws nothing: a file that cannot be
/// read says nothing here.
irsg::SunPosition sunOf(const Project& project, const Settings& settings);

} // namespace smat
