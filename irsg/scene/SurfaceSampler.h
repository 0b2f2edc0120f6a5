#pragma once

#include <functional>
#include <future>
#include <vector>

#include "irsg/radiance/RadianceTerms.h"
#include "irsg/render/opengl/TileStream.h"
#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/scene/SceneSurfaces.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

/// Asks an engine which surfaces the samples of tiles meet, and shades them: factors come out.
class SurfaceSampler {
  public:
    using Take = std::function<void(const SampleTile&, const GeometrySamples&)>;
    using Sampling = std::future<TileStream::Seconds>;

    /// Both must live as long.
    SurfaceSampler(const RadianceTerms& terms, StageClock& clock) : terms_(terms), clock_(clock) {}

    /// What of the scene stands in a tile as a camera sees it, between the depths it spans. The
    /// camera must live as long.
    SurfaceScene sceneOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                         const SampleTile& tile) const;
    SheetScene scenesOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                        const SampleSheet& sheet) const;

    /// Does work on the engine's thread and waits.
    void onEngine(const FrameEngine& engine, const std::function<void()>& work);

    /// Begins to sample tiles and to give the factors to `take`, on other threads; surfaces and
    /// camera must live until that is done.
    Sampling begin(const SceneSurfaces& surfaces, const CameraFrame& camera,
                   const std::vector<SampleTile>& tiles, bool withDistance, Take take);
    /// Waits for it. Of the time that others took, what was waited for counts, by stages in
    /// proportion; that of `take` is called `stage`.
    void waitFor(Sampling& sampling, const char* stage);
    /// Both.
    void sample(const SceneSurfaces& surfaces, const CameraFrame& camera,
                const std::vector<SampleTile>& tiles, bool withDistance, const char* stage,
                Take take);

  private:
    GeometryFactors geometryFactors(const SceneSurfaces& surfaces, const CameraFrame& camera) const;

    const RadianceTerms& terms_;
    StageClock& clock_;
    TileStream stream_;
};

} // namespace irsg
