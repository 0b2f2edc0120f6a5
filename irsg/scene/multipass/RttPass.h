#pragma once

#include "irsg/scene/CameraFrame.h"
#include "irsg/scene/SurfacePass.h"
#include "irsg/scene/antialiasing/SampleWindow.h"

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
