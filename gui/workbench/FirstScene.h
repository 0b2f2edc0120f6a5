#pragma once

#include "irsg/geometry/view/Vec3.h"
#include "smatcore/settings/Settings.h"

namespace smat::gui {

/// The scene in which a model is first seen: from the starboard bow and a little above, filling the
/// picture, in 3-5 um, in the clear air of a summer's day that comes with the program, over ground
/// and under the sun. `bounds` in m, in the axes of the model. All else is as in `usual`; without
/// the air, which a program without its data lacks, it is vacuum as before.
Settings firstScene(const irsg::BoundingBox& bounds, Settings usual);

} // namespace smat::gui
