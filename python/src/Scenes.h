#pragma once

#include <memory>
#include <mutex>

#include "irsg/scene/Renderer.h"
#include "python/src/Bindings.h"

namespace smat::python {

/// A renderer that serves one thread after the other.
class SharedRenderer {
  public:
    std::shared_ptr<irsg::Rendered> render(const irsg::Scene& scene, const irsg::SensorView& view,
                                           const irsg::Outputs& outputs) {
        const std::lock_guard lock(mutex_);
        return std::make_shared<irsg::Rendered>(renderer_.render(scene, view, outputs));
    }
    template <typename Work>
    auto with(const Work& work) {
        const std::lock_guard lock(mutex_);
        return work(renderer_);
    }

  private:
    std::mutex mutex_;
    irsg::Renderer renderer_;
};

} // namespace smat::python
