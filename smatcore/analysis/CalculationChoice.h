#pragma once

#include <string>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/data/ImageSource.h"

namespace smat {

/// How a sweep of the mode `auto` integrates its bands, and why, as results say it.
struct CalculationChoice {
    irsg::CalculationMode mode = irsg::CalculationMode::spectral;
    std::string reason; ///< "mode auto: spectral, as ...", empty where there is no choice
};

/// Cases that share their line of sight share what the air answers, so that it is lines of sight
/// that pay for training wideband-ck. Processor times in 3-5 um: the sample aircraft, whose plumes
/// are spectra of gas, trains 0.5 s and saves 5 ms a line (from 100 on), a grey box trains 0.23 s
/// and saves 1.2 ms (from 200 on); air of a file trains some hundredths and saves 5 to 40 ms (from
/// 3 on). The choice does not ask whether terms were kept on disk before: equal inputs have equal
/// results.
CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan);

/// How many different lines of sight the air is asked along.
std::size_t linesOfSight(const AnalysisPlan& plan);

} // namespace smat
