#pragma once

#include <memory>
#include <vector>

#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"

namespace irsg::bench {

/// The floor that rendering is compared with: OpenSceneGraph itself (cull traversal, state sorting,
/// drawing) putting the same model into the same float target with a shader that writes a constant.
class ConstantShaderRendering {
  public:
    ConstantShaderRendering(std::shared_ptr<const Model> model, const Sensor& sensor,
                            const Viewpoint& viewpoint);
    ~ConstantShaderRendering();
    /// Draws one frame and reads it back; the number of samples the model covers.
    int draw();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg::bench
