#pragma once

#include <functional>
#include <stop_token>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/CaseStore.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/support/Progress.h"
#include "smatcore/support/StageTimer.h"

namespace smat {

/// Makes the scene of a project; a SceneBuilder by reference, `std::ref(builder)`, or a test's own.
using SceneFactory = std::function<SceneDescription(const Project&, const Settings&)>;

/// What becomes of a run while it goes on.
struct RunControl {
    ProgressCallback progress = {};
    std::stop_token stop = {};
    StageTimer* timer = nullptr;
    /// Of a sweep: whose cases are taken from it and told to it.
    CaseStore* store = nullptr;
    /// Each case is checked in place of being calculated; nothing is drawn, told or written.
    bool isRehearsal = false;
};

/// Runs an analysis (F03, F04) of a plan and a scene that were made for its settings: case by case,
/// with progress and cancel. Window and command line share it, so that the same AnalysisData gives
/// the same numbers from both. Fills in the results. A stop asked for between two cases keeps what
/// was done and marks it `partial`; where some cases of a store belong to other runs, the result is
/// partial, too. A rehearsal throws all that the run would refuse before it calculates, and leaves
/// the data not run. Returns the first case as it was calculated. Throws InputError.
PlacedCase runAnalysis(AnalysisData& data, AnalysisPlan plan, SceneDescription scene,
                       const RenderDoor& door, const RunControl& control = {});

/// The same with plan and scene made of the settings.
class AnalysisGenerator {
  public:
    AnalysisGenerator(RenderDoor door, SceneFactory scenes);

    /// The cases, without drawing. Throws InputError.
    AnalysisPlan plan(const AnalysisData& data) const;
    PlacedCase run(AnalysisData& data, const ProgressCallback& progress = {},
                   std::stop_token stop = {}, StageTimer* timer = nullptr,
                   CaseStore* store = nullptr) const;

  private:
    RenderDoor door_;
    SceneFactory scenes_;
};

} // namespace smat
