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
/// that pay for training wideband-ck. By processor times in 3-5 um
/// the sample aircraft, whose plumes are spectra of gas, pays from 100 lines on and a grey box from
/// 120 (docs/atmosphere-accuracy.md); air of a file trains some hundredths of a second and saves 5
/// to 40 ms a line (from 3 on). The choice does not ask whether terms were kept on disk before:
/// equal inputs have equal results.
CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan);

/// How many different lines of sight the air is asked along.
std::size_t linesOfSight(const AnalysisPlan& plan);

} // namespace smat
