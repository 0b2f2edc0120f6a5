#pragma once

#include <cstddef>
#include <string>

#include "smatcore/analysis/ImageSource.h"

namespace smat {

/// How a sweep of the mode `auto` integrates its bands, and why, as results say it.
struct CalculationChoice {
    irsg::CalculationMode mode = irsg::CalculationMode::spectral;
    std::string reason; ///< "mode auto: spectral, as ...", empty where there is no choice
};

/// Terms that are kept on disk serve sweeps of some cases; where they are not, training is paid
/// back by a few hundred. Measured with the sample aircraft in 3-5 um: training takes 2.3 s of
/// processor time, a case 8 ms in the spectral mode and 2 to 3 ms at terms.
CalculationChoice chooseCalculation(const SceneDescription& scene, std::size_t cases);

} // namespace smat
