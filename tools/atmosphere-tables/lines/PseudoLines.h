#pragma once

#include <cstdint>
#include <vector>

#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LowtranBands.h"

namespace irsg::lbl {

/// What all pseudo-lines of a gas have in common.
struct PseudoGas {
    Gas gas = Gas::O3;
    float airWidth_cm_atm = 0.07f, selfWidth_cm_atm = 0.1f, widthExponent = 0.75f;
    std::uint64_t seed = 1;        ///< of the positions; the same seed gives the same lines
    double cellWidth_per_cm = 5.0; ///< divides LowtranBands::step_per_cm
    std::size_t linesInCell = 8;
    std::vector<double> pressures_atm = {1.0}; ///< at which a cell is fitted, all alike
};
/// Water, ozone and methane with the mean widths of their lines and cells for the pressures at
/// which they mostly absorb; LogicError for other gases.
PseudoGas pseudoGas(Gas gas);

/// A line of a cell, which is repeated over the spectrum.
struct CellLine {
    double place_per_cm = 0.0; ///< from the beginning of the cell
    double strength = 0.0;     ///< cm-1 per unit of 1 / K
};

/// Lines of a cell whose mean transmittance is exp(-(K u p^n)^a), p in atmospheres, as nearly as
/// Lorentz lines can: positions are drawn at random, strengths are found by least squares
/// (Levenberg-Marquardt) at optical depths of 0.005 to 4.5 and the gas's pressures. The best of
/// several draws.
struct Cell {
    std::vector<CellLine> lines;
    double rmsError = 0.0; ///< of the transmittance, over all pressures
};
Cell fitCell(double exponent, double pressureExponent, const PseudoGas& gas);

/// Lines in [lower, upper] which absorb as LOWTRAN's band model: cells around every point, each
/// turned by a random angle and scaled by K, which runs smoothly from point to point; then cell by
/// cell a correction until the transmittance over 20 cm-1 at 1013 hPa is that of the model. The
/// lower energy makes strengths follow temperature as the model's W does (partition sum ~ T^1.5).
/// Water's lines are made for a cut at 25 cm-1 without pedestal and without continuum. `points` lie
/// 5 cm-1 apart and go at least one beyond each end where the gas absorbs there. The temperature of
/// reference is 296 K.
std::vector<Line> pseudoLines(const std::vector<BandPoint>& points, const PseudoGas& gas,
                              double lower_per_cm, double upper_per_cm);

} // namespace irsg::lbl
