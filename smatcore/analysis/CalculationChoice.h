#pragma once

#include <string>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// How a sweep of the mode `auto` integrates its bands, and why, as results say it.
struct CalculationChoice {
    irsg::CalculationMode mode = irsg::CalculationMode::spectral;
    std::string reason; ///< "mode auto: spectral, as ...", empty where there is no choice
};

/// Cases that share their line of sight share what the air answers, so that it is lines of sight
/// that pay for training wideband-ck, and so many more or fewer of them as the air is asked less or
/// more for each: a level line over ranges has one sky for all, a background of many rows many, and
/// spectra of gas are summed case by case. By processor times (docs/atmosphere-accuracy.md)
/// training costs as much as 350 to 735 paths do by how dense the nodes of the band lie, 2.5 times
/// as much with spectra of gas; air of a file pays from 3 lines on. The choice does not ask whether
/// quadrature points were kept on disk before: equal inputs have equal results.
CalculationChoice chooseCalculation(const SceneDescription& scene, const AnalysisPlan& plan);

/// How many different lines of sight the air is asked along.
std::size_t linesOfSight(const AnalysisPlan& plan);

} // namespace smat
