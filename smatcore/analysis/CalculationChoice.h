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
/// that pay for training wideband-ck: 2.3 s of processor time with the sample aircraft in 3-5 um,
/// where a line of sight takes 8 ms in the spectral mode and 2 to 3 ms in this one. The choice does
/// not ask whether terms were kept on disk before: equal inputs have equal results.
CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan);

} // namespace smat
