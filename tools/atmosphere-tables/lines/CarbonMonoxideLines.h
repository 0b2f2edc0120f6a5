#pragma once

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Energy of a level of 12C16O, cm-1 above v = 0, J = 0: Dunham's expansion (J. L. Dunham 1932,
/// Phys. Rev. 41, 721) with the constants of vibration of Huber and Herzberg 1979 and constants of
/// rotation fitted to the energies that HITRAN2012's lines hold (v to 4, J to 95). `massRatio` is
/// the square root of the reduced mass of 12C16O over that of the isotopologue.
double carbonMonoxideLevel_per_cm(int v, int J, double massRatio = 1.0);

/// The lines v to v + 1 of CO in closed form, v to 14 and |m| to 130, so to 3000 K: 12C16O, 13C16O
/// and 12C18O. Strengths are those of v = 0 and 1 in HITRAN2012 to 0.1 percent, with their factors
/// of Herman and Wallis, and go on as (v + 1) (1 - 0.0034 v). Ascending; intensities at 296 K,
/// however small. The overtones are not among them.
LineList carbonMonoxideLines();

} // namespace irsg::lbl
