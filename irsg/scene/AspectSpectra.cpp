#include "irsg/scene/AspectSpectra.h"

#include <utility>

#include "irsg/scene/KeyNumbers.h"

namespace irsg {

namespace {

/// Whether all of a frame is one object that is sampled for its line of sight.
bool isAlongRange(const FramePlan& plan, const FrameBackgrounds& backgrounds) {
    return plan.alongRange.size() == 1 && plan.seen.empty() && backgrounds.areUniform();
}

} // namespace

bool AspectSpectra::mayHave(const FrameRequest& request) {
    return request.alongRange && request.sampledFrom_m && !request.withErrors &&
           !request.withSources && !request.bySurface && !request.isScaled &&
           request.bands.size() == 1 && request.scene.entities.size() == 1 &&
           !request.scene.terrain;
}

AspectSpectra::Key AspectSpectra::keyOf(const FrameRequest& request) {
    const Scene& scene = request.scene;
    const Entity& entity = scene.entities.front();
    Key key{EntityKey::of(entity),    entity.otherStates, entity.pose,
            {*request.sampledFrom_m}, scene.settings,     AtmosphereIdentity(scene.environment),
            scene.environment.sun,    request.bands};
    appendTo(key.numbers, prepared_.lineOfSight(entity, request.view.viewpoint.position_m));
    appendTo(key.numbers, prepared_.referencePoint(entity));
    return key;
}

std::optional<Frame> AspectSpectra::frame(const FrameRequest& request,
                                          const std::vector<ObjectGeometry>& geometry,
                                          const FrameEngine& engine) {
    if (!mayHave(request) || geometry.front().hidden != HiddenPart::none)
        return std::nullopt;
    const Key key = keyOf(request);
    const Known* const known = known_.find([&](const Known& one) { return one.key == key; });
    if (known == nullptr)
        return std::nullopt;
    SceneEvaluation evaluation = evaluator_.atOtherRange(request, geometry, known->evaluation);
    const bool isSliced = evaluation.geometry.front().slices_m.size() > 1;
    if ((isSliced && !known->spectra->isSliced()) ||
        evaluation.geometry.front().mirror.key() !=
            known->evaluation.geometry.front().mirror.key() ||
        !SpectraBeforeAir::differByPathAlone(terms_, *evaluation.sampled,
                                             *known->evaluation.sampled))
        return std::nullopt;
    FrameBackgrounds backgrounds =
        evaluator_.backgrounds(request, evaluation, engine.terrainPainter);
    SceneSurfaces surfaces{request.scene, engine, std::move(evaluation), known->shading, {}, {}};
    FramePlan plan = planner_.plan(request, surfaces, backgrounds);
    if (!isAlongRange(plan, backgrounds))
        return std::nullopt;
    return Frame{request, std::move(surfaces), std::move(backgrounds), std::move(plan),
                 known->spectra};
}

void AspectSpectra::addTo(Frame& frame) {
    if (!mayHave(frame.request) || !isAlongRange(frame.plan, frame.backgrounds))
        return;
    const SceneEvaluation& evaluation = frame.evaluation();
    if (!SpectraBeforeAir::existOf(evaluation.evaluated->radiometry, *evaluation.sampled))
        return;
    const auto drawn = sampler_.drawnFromOne(frame, frame.plan.alongRange.front(), false);
    frame.spectra = std::make_shared<const SpectraBeforeAir>(
        drawn.of.view, drawn.rows, drawn.of.distance_m, *evaluation.evaluated, occluderStacks_);
    known_.add({keyOf(frame.request), evaluation, frame.shading(), frame.spectra});
}

} // namespace irsg
