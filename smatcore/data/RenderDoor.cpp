#include "smatcore/data/RenderDoor.h"

#include <memory>

#include "irsg/scene/Renderer.h"

namespace smat {

RenderDoor openRenderDoor() {
    const auto renderer = std::make_shared<irsg::Renderer>();
    return {
        .begin =
            [renderer](const irsg::Scene& scene, const irsg::SensorView& view,
                       const irsg::Outputs& outputs) {
                return renderer->begin(scene, view, outputs);
            },
        .referencePoint =
            [renderer](const irsg::Entity& entity) { return renderer->referencePoint(entity); },
        .description =
            [renderer](const irsg::Scene& scene) { return renderer->rendererDescription(scene); },
        .explainer =
            [renderer](const irsg::Scene& scene, const irsg::SensorView& view) {
                return renderer->explainer(scene, view);
            },
        .stageTimes = [renderer] { return renderer->stageTimes(); },
        .check =
            [renderer](const irsg::Scene& scene, const irsg::SensorView& view,
                       const irsg::Outputs& outputs) { renderer->check(scene, view, outputs); },
        .reach_m = [renderer](const irsg::Entity& entity) { return renderer->reach_m(entity); }};
}

} // namespace smat
