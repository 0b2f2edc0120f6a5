#pragma once

#include <functional>
#include <string>

#include "irsg/render/values/PixelExplanation.h"
#include "irsg/scene/Outputs.h"
#include "irsg/scene/PendingRender.h"
#include "irsg/scene/Scene.h"

namespace smat {

/// What smatcore asks of a renderer: the functions of an irsg::Renderer, or closed forms that
/// analyses are tested against without OpenGL. Copies share the renderer, which any one thread may
/// use at a time.
struct RenderDoor {
    /// See irsg::Renderer::begin.
    std::function<irsg::PendingRender(const irsg::Scene&, const irsg::SensorView&,
                                      const irsg::Outputs&)>
        begin;
    /// Of an entity, in model axes.
    std::function<irsg::Vec3(const irsg::Entity&)> referencePoint;
    std::function<std::string(const irsg::Scene&)> description;
    /// See irsg::Renderer::explainer. What it returns must not outlive the door.
    std::function<std::function<irsg::PixelExplanation(int x, int y)>(const irsg::Scene&,
                                                                      const irsg::SensorView&)>
        explainer;
    std::function<irsg::StageTimes()> stageTimes; ///< since it was opened
    /// See irsg::Renderer::check; closed forms refuse nothing.
    std::function<void(const irsg::Scene&, const irsg::SensorView&, const irsg::Outputs&)> check =
        [](const irsg::Scene&, const irsg::SensorView&, const irsg::Outputs&) {};
    /// See irsg::Renderer::reach_m; closed forms are points.
    std::function<double(const irsg::Entity&)> reach_m = [](const irsg::Entity&) { return 0.0; };

    bool isOpen() const { return begin != nullptr; }
    irsg::Rendered render(const irsg::Scene& scene, const irsg::SensorView& view,
                          const irsg::Outputs& outputs) const {
        return begin(scene, view, outputs).get();
    }
};

/// Makes what a door leads to.
using DoorMaker = std::function<RenderDoor()>;

/// The door to a new irsg::Renderer.
RenderDoor openRenderDoor();

} // namespace smat
