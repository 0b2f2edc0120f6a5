#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/view/Vec3.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/tools/PathGeometry.h"

namespace smat {

/// The line of sight from the camera to the target's reference point as settings place them
/// (camera and target), altitudes, range and both angles: what an image with these settings
/// asks the air for. `referencePoint_m` is in model axes.
PathGeometryInput viewerGeometry(const Project& project, const Settings& settings,
                                 const irsg::Vec3& referencePoint_m);

/// Where the camera of a project looks, in the axes of its target: the point that the project
/// names, else the centre of what is opaque in the infrared, as the renderer takes it; the origin
/// where the model or its database cannot be read, and where there is none.
irsg::Vec3 targetReferencePoint(const Project& project, SceneBuilder& scenes);

/// The atmospheres as arguments of a command, each after a space; " none" where there are none.
std::string atmosphereArguments(const std::vector<std::filesystem::path>& air);

/// The command that makes the same radiative output from a terminal, with `air` as the
/// atmospheres, `none` where it is empty, and the words of its quantities (see
/// radiativeQuantities). The sun's distance is that of the day, the mean one without.
std::string radiativeCommand(const std::vector<std::filesystem::path>& air,
                             const std::vector<std::string>& words,
                             const PathGeometryInput& geometry, const irsg::SpectralRange& band,
                             const irsg::SunPosition& sun, std::optional<double> dayOfYear,
                             const std::string& outputFile,
                             const std::vector<double>& referenceDistances_m = {});

/// Distances that the spectra of a project's models were measured from, each once, ascending; none
/// of databases that cannot be read.
std::vector<double> referenceDistancesOf_m(const Project& project, SceneBuilder& scenes);

} // namespace smat
