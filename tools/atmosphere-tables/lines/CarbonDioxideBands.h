#pragma once

#include <string>
#include <vector>

#include "tools/atmosphere-tables/lines/CarbonDioxideLevels.h"
#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// A vibrational band of CO2.
struct CarbonDioxideBand {
    int isotopologue = 1;
    std::string upper, lower; ///< states such as "00011": v1 v2 l2 v3 r
    double strength = 0.0;    ///< sum of the lines at 296 K, natural abundance included
};

/// Bands of a list such as that of Lamouroux et al. 2010 (J. Quant. Spectrosc. Radiat. Transfer
/// 111, 2321): isotopologue, upper and lower state without blanks, then perhaps I or II for the two
/// halves of a band of an isotopologue without symmetry (which are added), then the strength.
/// Throws InputError naming the first ten lines that cannot be read.
std::vector<CarbonDioxideBand> readCarbonDioxideBands(const std::vector<std::string>& lines,
                                                      const std::string& file);

/// The lines of a band: positions from the levels of both states, intensities as nu times
/// Hoenl-London factor times population times (1 - exp(-c2 nu / T)), normalised to the strength of
/// the band; widths by |m|. J goes a little beyond the known levels. Levels that nuclear spin
/// forbids are left out (16O and 18O twice). Empty where a state is not known.
std::vector<Line> bandLines(const CarbonDioxideBand& band, const CarbonDioxideLevels& levels);

/// Hoenl-London factor, up to a constant, of a line from J'' with angular momentum l'' to l', for
/// branch -1 (P), 0 (Q), +1 (R). Bands that change l by more than 1 are taken as J + 1, J and 2 J +
/// 1.
double hoenlLondonFactor(int branch, int J, int lowerL, int upperL);

} // namespace irsg::lbl
