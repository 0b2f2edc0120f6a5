#pragma once

#include <functional>
#include <stop_token>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/CaseStore.h"
#include "smatcore/data/ImageSource.h"
#include "smatcore/support/Progress.h"
#include "smatcore/support/StageTimer.h"

namespace smat {

/// Makes the scene of a project; a SceneBuilder by reference, `std::ref(builder)`, or a test's own.
using SceneFactory = std::function<SceneDescription(const Project&, const Settings&)>;

/// Runs analyses (F03, F04): plan, then case by case with progress and cancel. Window and command
/// line share it, so that the same AnalysisData gives the same numbers from both.
class AnalysisGenerator {
  public:
    AnalysisGenerator(ImageSource& source, SceneFactory scenes);

    /// The cases, without drawing. Throws InputError.
    AnalysisPlan plan(const AnalysisData& data) const;
    /// Fills in the results. A stop asked for between two cases keeps what was done and marks it
    /// `partial`. Of a sweep the cases of a `store` are taken from it and told to it; where some
    /// belong to other runs, the result is partial, too. The target's attitude and the viewpoint
    /// are put back as they were, whatever happens (trap T44). Throws InputError.
    void run(AnalysisData& data, const ProgressCallback& progress = {}, std::stop_token stop = {},
             StageTimer* timer = nullptr, CaseStore* store = nullptr);

  private:
    ImageSource& source_;
    SceneFactory scenes_;
};

} // namespace smat
