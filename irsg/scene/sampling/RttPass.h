#pragma once

#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/CameraFrame.h"

namespace irsg {

/// Renders objects to a texture: what a strategy of antialiasing draws with.
class RttPass {
  public:
    virtual ~RttPass() = default;

    /// Largest side of a drawing, samples.
    virtual int largestSide() const = 0;
    /// Draws the entities of a window as a camera sees them, no background behind.
    virtual void draw(const CameraFrame& camera, const SampleWindow& window,
                      RadianceSamples& samples) = 0;
};

} // namespace irsg
