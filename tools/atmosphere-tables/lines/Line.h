#pragma once

#include <string>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg::lbl {

/// c2 = h c / k (CODATA 2018), and the temperature that the strengths of line lists are given at
/// (HITRAN).
inline constexpr double secondRadiationConstant_cm_K = 1.438776877;
inline constexpr double referenceTemperature_K = 296.0;

/// A spectral line, with the parameters of the HITRAN database (Gordon et al. 2022).
struct Line {
    double wavenumber_per_cm = 0.0;
    double intensity = 0.0; ///< at 296 K, cm-1 / (molecule cm-2), natural abundance included
    double lowerEnergy_per_cm = 0.0; ///< E''
    float airWidth_cm_atm = 0.07f;   ///< half width at half maximum, 296 K
    float selfWidth_cm_atm = 0.1f;
    float widthExponent = 0.7f; ///< n: width ~ (296/T)^n
    float airShift_cm_atm = 0.0f;
    int isotopologue = 1; ///< HITRAN number; decides mass and partition sum
};

/// The lines of one gas, ascending in wavenumber.
struct LineList {
    Gas gas = Gas::H2O;
    std::vector<Line> lines;
    /// One sentence a source: range, origin, expected error. Goes into the header of the tables.
    std::vector<std::string> origins;
};

} // namespace irsg::lbl
