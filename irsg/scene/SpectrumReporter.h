#pragma once

#include <memory>
#include <vector>

#include "irsg/radiance/ScaledView.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/InterReflection.h"
#include "irsg/scene/RenderErrorEstimator.h"
#include "irsg/scene/SceneEvaluator.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

struct SpectrumOfView {
    IntensitySpectrum spectrum;
    std::unique_ptr<const ScaledView> scaled; ///< null where no scales were asked for
};

/// Makes spectra of the factors of a view.
class SpectrumReporter {
  public:
    /// All must live as long; `occluderStacks` may grow.
    SpectrumReporter(SceneEvaluator& evaluator, InterReflection& interReflection,
                     RenderErrorEstimator& errors, StageClock& clock)
        : evaluator_(evaluator),
          interReflection_(interReflection),
          errors_(errors),
          clock_(clock) {}

    /// At positive wavenumbers in any order. `scalings`: what the view is to be a function of.
    SpectrumOfView spectrum(const Frame& frame, const ViewGeometry& factors,
                            const std::vector<double>& wavenumbers_per_cm,
                            const std::vector<ScalingInput>& scalings);

  private:
    SceneEvaluator& evaluator_;
    InterReflection& interReflection_;
    RenderErrorEstimator& errors_;
    StageClock& clock_;
};

} // namespace irsg
