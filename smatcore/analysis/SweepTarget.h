#pragma once

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
    /// Chooses by a few of the plan's cases, and changes how `scene` is calculated. Nothing where
    /// there is no target, or none of a spectrum.
    static std::optional<SweepTarget> choose(const RenderDoor& door, const CasePlacer& placer,
                                             SceneDescription& scene, const AnalysisPlan& plan,
                                             const Settings& settings);

    const TargetChoice& choice() const { return choice_; }
    /// Remarks on a case whose errors are larger than the target.
    void check(const std::vector<irsg::RenderReport>& reports, CaseWarnings& warnings) const;

  private:
    double target_ = 0.0;
    TargetChoice choice_;
};

} // namespace smat
