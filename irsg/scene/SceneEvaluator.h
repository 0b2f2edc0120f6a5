#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/SceneSampling.h"
#include "irsg/radiance/WidebandPoints.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/SceneEvaluation.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

/// A scene at the wavelengths of a spectrum, each of which is an output.
struct EvaluatedSpectrum {
    std::vector<SampledBand> bands; ///< one
    std::unique_ptr<EvaluatedScene> scene;
    BackgroundBehind behind;
};

/// Evaluates the spectra of a scene: asks the atmosphere, chooses the nodes of each band, and makes
/// radiances of temperatures and materials. Caches hold what the atmosphere answered, the nodes of
/// bands, sampled and evaluated scenes and wideband points, by what each follows from.
class SceneEvaluator {
  public:
    /// All must live as long; `occluderStacks` may grow.
    SceneEvaluator(const RadianceTerms& terms, const OccluderStacks& occluderStacks,
                   StageClock& clock)
        : terms_(terms), occluderStacks_(occluderStacks), clock_(clock) {}

    /// `geometry`: by entity, the paths that the atmosphere is asked along. Throws InputError where
    /// no atmosphere answers.
    SceneEvaluation evaluate(const FrameRequest& request, std::vector<ObjectGeometry> geometry);
    /// The same of a scene that was evaluated at another range of the same line of sight: what its
    /// surfaces send stays that, only paths and background are those of the request.
    SceneEvaluation atOtherRange(const FrameRequest& request, std::vector<ObjectGeometry> geometry,
                                 const SceneEvaluation& known);
    /// By output. Throws what SceneBackground::draw throws.
    FrameBackgrounds backgrounds(const FrameRequest& request, const SceneEvaluation& evaluation,
                                 TerrainPainter& terrainPainter);
    /// Along the paths of `geometry`; wavelengths ascend.
    EvaluatedSpectrum atWavelengths(const FrameRequest& request,
                                    const std::vector<ObjectGeometry>& geometry,
                                    const std::vector<double>& wavelengths_um);

    /// What the atmosphere of the scene that was evaluated last answered.
    AtmosphericQueryCache& answers() { return answers_; }
    /// The scene along other paths; all must live as long.
    AtmosphereScene airScene(const FrameRequest& request,
                             const std::vector<ObjectGeometry>& geometry) const {
        return {terms_,
                request.scene.entities,
                geometry,
                request.scene.settings,
                request.centre,
                request.pathDepth,
                static_cast<std::size_t>(std::max(request.lookedAt, 0))};
    }
    /// Samples bands with the answers of a scene's atmosphere, or of another; both must live as
    /// long.
    SampledScenes::Sampler sampler(const Scene& scene, AtmosphericQueryCache& answers);
    /// The nodes that an atmosphere has of itself, null where it has none.
    std::shared_ptr<const SpectralSampling> nodes(const Environment& environment,
                                                  const Band& band) {
        return sampling_.nodes(environment, band);
    }
    /// Of one band of a request alone, also where it is sampled with others.
    std::shared_ptr<const SpectralSampling>
    samplingOf(const FrameRequest& request, const SceneEvaluation& evaluation, std::size_t band);

  private:
    /// The air along the paths, and what is behind the objects; nothing of surfaces.
    SceneEvaluation pathsOf(const FrameRequest& request, std::vector<ObjectGeometry> geometry);
    std::shared_ptr<const WidebandPoints> wideband(const Scene& scene, const Band& band);
    /// By drawn row, in the scene's states and the others of its sweep.
    std::vector<bool> hotRows(const Scene& scene, const std::vector<ObjectGeometry>& geometry,
                              const std::shared_ptr<const SampledScene>& sampled,
                              const SceneRadiometry& radiometry);

    const RadianceTerms& terms_;
    const OccluderStacks& occluderStacks_;
    StageClock& clock_;
    SceneBackground background_;
    AtmosphericQueryCache answers_;
    SceneSampling sampling_;
    SampledScenes sampledScenes_;
    /// So many that bands and samples can take turns.
    RecentlyUsed<std::shared_ptr<const WidebandPoints>> widebandPoints_{128};
    RadiometryCache radiometry_;
};

} // namespace irsg
