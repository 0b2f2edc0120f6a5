#pragma once

#include <stop_token>
#include <string>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CaseStore.h"
#include "smatcore/analysis/MonteCarloData.h"

namespace smat {

/// What cannot be asked of Monte Carlo, told by those that run it.
irsg::InputError monteCarloRefusal(std::string position, std::string value, std::string expected);

/// Repeats an analysis of intensities over the scales of its scaling files (F55 to F57). Geometry
/// is drawn once per case and the air asked once; a draw is a few sums (irsg::ScaledView).
class MonteCarlo {
  public:
    MonteCarlo(RenderDoor door, SceneFactory scenes);

    /// Those of an analysis as its draws are made with: without scales of loading, and with fixed
    /// steps, as draws are of the cases that there are before any is drawn.
    static Settings settingsOf(const AnalysisData& analysis);

    /// Fills in the results. A stop keeps the cases and draws there are, at least 256 draws once a
    /// case is drawn, and marks them `partial`. Throws InputError: options that cannot be, an image
    /// analysis, no scaling files, no scale that varies, more than 5e7 values.
    void run(MonteCarloData& data, const ProgressCallback& progress = {}, std::stop_token stop = {},
             StageTimer* timer = nullptr);
    /// The same case by case, for runs in parts: each is drawn and goes through all draws before
    /// the next one. The table comes out with the bytes of one run, and no values of draws. Throws
    /// InputError, too, for what follows from all cases (a ranking, a standard error that ends the
    /// draws) and for a spectrum, which has one.
    void run(MonteCarloData& data, CaseStore& store, const ProgressCallback& progress = {},
             std::stop_token stop = {}, StageTimer* timer = nullptr);

    /// Throws all that run() would refuse before it draws, of a run in parts where there is a
    /// store, and returns the plan. The data are not run; they hold what there is to warn of.
    AnalysisPlan rehearse(MonteCarloData& data, CaseStore* store = nullptr);

  private:
    RenderDoor door_;
    SceneFactory scenes_;
};

} // namespace smat
