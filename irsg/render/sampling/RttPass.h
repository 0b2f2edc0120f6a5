#pragma once

#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Renders objects to a texture: what a strategy of antialiasing draws with.
class RttPass {
  public:
    virtual ~RttPass() = default;

    /// Largest side of a drawing, samples.
    virtual int largestSide() const = 0;
    /// Draws the entities of each tile of a sheet as a camera sees them, no background behind.
    virtual void draw(const CameraFrame& camera, const SampleSheet& sheet,
                      RadianceSamples& samples) = 0;
};

} // namespace irsg
