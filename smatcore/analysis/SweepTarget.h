#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/TargetChoice.h"

namespace smat {

/// The target error of a sweep or an image (`render.targetError`): what was chosen for it, and
/// which cases miss it.
class SweepTarget {
  public:
    /// Chooses by a few of the plan's cases, which `show` sets in the source, and changes `scene`
    /// and the source's view of it. Nothing where there is no target, or none of a spectrum.
    static std::optional<SweepTarget> choose(ImageSource& source, SceneDescription& scene,
                                             const AnalysisPlan& plan, const Settings& settings,
                                             const std::function<void(const AnalysisCase&)>& show);

    const TargetChoice& choice() const { return choice_; }
    /// Remarks on a case whose errors are larger than the target.
    void check(const ImageSource::Reports& reports, CaseWarnings& warnings) const;

  private:
    double target_ = 0.0;
    TargetChoice choice_;
};

} // namespace smat
