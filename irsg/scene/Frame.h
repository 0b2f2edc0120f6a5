#pragma once

#include <memory>

#include "irsg/radiance/SpectraBeforeAir.h"
#include "irsg/scene/FramePlan.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/SceneSurfaces.h"

namespace irsg {

/// A view that is ready to be sampled: what the first stages made of a request. It stays where it
/// is while something is sampled.
struct Frame {
    FrameRequest request;
    SceneSurfaces surfaces;
    FrameBackgrounds backgrounds;
    FramePlan plan;
    /// What the one object of the frame sends; null: samples give it.
    std::shared_ptr<const SpectraBeforeAir> spectra = nullptr;

    const Scene& scene() const { return request.scene; }
    const RenderSettings& settings() const { return request.scene.settings; }
    const Sensor& sensor() const { return request.view.sensor; }
    const SceneEvaluation& evaluation() const { return surfaces.evaluation; }
    const SurfaceRows& rows() const { return surfaces.rows(); }
    const SurfaceShading& shading() const { return surfaces.shading; }
    const std::shared_ptr<const LightExchange>& exchange() const {
        return surfaces.shading.between.exchange;
    }
    /// Null for none.
    SceneLight* light() const { return surfaces.shading.between.light.get(); }
};

} // namespace irsg
