#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/radiance/OccluderStacks.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/scene/AspectSampler.h"
#include "irsg/scene/AspectSpectra.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/FramePlanner.h"
#include "irsg/scene/FrameSampler.h"
#include "irsg/scene/HazeRenderer.h"
#include "irsg/scene/InterReflection.h"
#include "irsg/scene/PixelExplainer.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/RenderErrorEstimator.h"
#include "irsg/scene/RenderReporter.h"
#include "irsg/scene/Renderer.h"
#include "irsg/scene/SampleEngines.h"
#include "irsg/scene/SceneEvaluator.h"
#include "irsg/scene/SpectrumReporter.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/SurfaceSampler.h"
#include "irsg/scene/SurfaceShader.h"

namespace irsg {

/// The stages of a renderer, each with the caches that are its own, in the order in which a call
/// goes through them. What they share stands first.
struct Renderer::Impl {
    explicit Impl(const RadianceTerms& list) : terms(list) {}

    const RadianceTerms& terms;
    StageClock clock;
    OccluderStacks occluderStacks; ///< numbers of what lies before surfaces, which samples give and
                                   ///< spectra take
    PreparedEntities prepared;
    TerrainRays terrainRays;

    SampleEngines engines{prepared, terrainRays, clock};
    SceneEvaluator evaluator{terms, occluderStacks, clock};
    InterReflection interReflection{prepared, occluderStacks, clock};
    SurfaceShader shader{terms, prepared, terrainRays, interReflection, clock};
    SurfaceSampler surfaces{terms, clock};
    FramePlanner planner{terms, prepared, surfaces, clock};
    AspectSampler aspects{terms, prepared, planner, surfaces, occluderStacks, clock};
    AspectSpectra spectraAlong{terms, prepared, planner, evaluator, aspects, occluderStacks};
    FrameSampler sampler{terms, surfaces, aspects, occluderStacks, clock};
    RenderErrorEstimator errors{terms, evaluator, occluderStacks};
    RenderReporter reporter{errors, clock};
    SpectrumReporter spectra{evaluator, interReflection, errors, clock};
    HazeRenderer haze{prepared, evaluator, sampler, aspects, clock};

    /// Checks a request and takes it through the stages before sampling. Scene and view must live
    /// as long as the frame.
    Frame frame(const Scene& scene, const SensorView& view, const Outputs& outputs);
    std::vector<RenderReport> reports(const Frame& frame) {
        return frame.spectra ? withHaze(frame, reporter.reports(frame))
                             : reports(frame, sampler.factorsOf(frame));
    }
    /// With the haze of a picture in each band, where there is scattering.
    std::vector<RenderReport> reports(const Frame& frame, const ViewGeometry& factors);
    std::vector<RenderReport> withHaze(const Frame& frame, std::vector<RenderReport> all);
    /// What haze makes of the sums over the objects of a view in a band, as in a picture.
    HazeGains hazeGains(const Scene& scene, const SensorView& view, const Band& band,
                        double pathDepth);
    void renderImage(const Frame& frame, const Outputs& outputs, Rendered& result);
};

/// Reports that were begun.
struct Renderer::Begun {
    Begun(Impl& of, Scene ofScene, SensorView ofView, Outputs ofOutputs)
        : scene(std::move(ofScene)),
          view(std::move(ofView)),
          outputs(std::move(ofOutputs)),
          frame(of.frame(scene, view, outputs)) {}
    Begun(const Begun&) = delete;
    Begun& operator=(const Begun&) = delete;
    ~Begun() {
        if (drawing)
            drawing->wait();
    }

    const Scene scene;
    const SensorView view;
    const Outputs outputs;
    const Frame frame; // of these
    std::shared_ptr<ViewSampling> drawing;
};

} // namespace irsg
