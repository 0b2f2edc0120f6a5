#pragma once

#include <vector>

#include "irsg/scene/antialiasing/SampleWindow.h"
#include "irsg/scene/antialiasing/ZoomEntityInfo.h"

namespace irsg {

/// How the image plane is cut into windows and how finely each is sampled.
class AbstractZoomAntialiasingStrategy {
  public:
    virtual ~AbstractZoomAntialiasingStrategy() = default;

    /// Windows that hold every object. Objects whose extents overlap share windows; the parts that
    /// windows leave out to finer ones make every point of an object's extent drawn exactly once.
    virtual std::vector<SampleWindow> windows(const std::vector<ZoomEntityInfo>& objects) const = 0;
};

} // namespace irsg
