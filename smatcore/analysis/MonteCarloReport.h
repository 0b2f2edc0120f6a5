#pragma once

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/MonteCarlo.h"

namespace smat {

/// Says in table, summary and provenance what a Monte Carlo analysis found: its values, abscissae,
/// statistic and ranking are filled in.
void reportMonteCarlo(MonteCarloData& data, const AnalysisPlan& plan,
                      const SceneDescription& scene);

} // namespace smat
