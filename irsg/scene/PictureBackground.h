#pragma once

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/scene/Frame.h"

namespace irsg {

/// The background of a picture, such that its pixels and the sums over the object are one number.
///
/// Where the object has a background of its own directions (BackgroundBehind), the rows of a
/// picture are an interpolation that is right to half a percent, and in the pixels of a small
/// object they are means over more than it hides. So rows are scaled, by at most that half a
/// percent, to the object's own background in the mean over its pixels; what is left is behind the
/// object alone (FrameBackground::behindAt). With several objects, and where both are one, that of
/// the frame.
FrameBackground pictureBackground(const Frame& frame, const FrameReduction& pixels);

} // namespace irsg
