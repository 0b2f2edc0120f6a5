#pragma once

#include "smatcore/project/Project.h"

namespace smat::gui {

/// Settings of a project, with the colour scale and the limits of its first image analysis of
/// radiance in the same band where the project sets none: in these the infrared display begins, so
/// that it looks as the image will. The colour map is that of the project.
Settings lookOf(const Project& project, const Settings& settings);

} // namespace smat::gui
