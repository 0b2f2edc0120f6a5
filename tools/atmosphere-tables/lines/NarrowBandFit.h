#pragma once

#include <vector>

#include "irsg/gas/NarrowBand.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"

namespace irsg::lbl {

/// What a fit of narrow bands is of.
struct NarrowBandTask {
    std::vector<double> centres_per_cm;            ///< ascending, a width apart
    double width_per_cm = 5.0, step_per_cm = 0.01; ///< of a band, of the line-by-line grid
    double temperature_K = 300.0, pressure_hPa = 1013.25;
    /// Half widths over which the spacing is counted, cm-1: of collisions in trace amounts, and of
    /// the Doppler effect per cm-1 of wavenumber.
    double collision_per_cm = 0.07, dopplerPerWavenumber = 1e-6;
    StrengthLaw law = StrengthLaw::malkmus;
    LineShape shape;
    double weakest_cm2 = 0.0; ///< lines whose peak is lower are left out
};

/// Mean cross section and inverse spacing of the lines in one band.
struct FittedBand {
    double crossSection_cm2 = 0.0;
    double inverseSpacing_cm = 0.0;
    double rmsError = 0.0; ///< of the absorptance, relative, at the depths of the fit
};

/// The mean of each band is that of line by line, its spacing is the one with which the
/// absorptance comes nearest to line by line at weak depths X of 0.03 to 30, by least squares of
/// relative errors.
std::vector<FittedBand> fitNarrowBands(const LineList& list, const PartitionSums& partition,
                                       const NarrowBandTask& task);

} // namespace irsg::lbl
