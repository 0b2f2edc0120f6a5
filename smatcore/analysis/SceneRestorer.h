#pragma once

#include "smatcore/data/ImageSource.h"

namespace smat {

/// Puts targets and camera back where the settings place them when an analysis ends, also by an
/// exception, so that whoever shares the renderer finds it unturned (trap T44).
class SceneRestorer {
  public:
    SceneRestorer(ImageSource& source, const SceneDescription& scene, irsg::Viewpoint viewpoint)
        : source_(source), scene_(scene), viewpoint_(viewpoint) {}
    ~SceneRestorer() {
        for (std::size_t i = 0; i < scene_.entities.size(); ++i) {
            source_.setPose(i, scene_.entities[i].pose);
            source_.setState(i, scene_.entities[i].state);
        }
        source_.setViewpoint(viewpoint_);
    }
    SceneRestorer(const SceneRestorer&) = delete;
    SceneRestorer& operator=(const SceneRestorer&) = delete;

  private:
    ImageSource& source_;
    const SceneDescription& scene_;
    irsg::Viewpoint viewpoint_;
};

} // namespace smat
