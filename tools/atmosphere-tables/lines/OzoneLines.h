#pragma once

#include <string>
#include <vector>

#include "tools/atmosphere-tables/lines/AsymmetricTop.h"
#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Interacting states of 16O3. Their constants are fitted to energies that a line list holds as
/// lower levels of hot bands and as sums of position and lower energy (HITRAN2016 and 2020): rms
/// 0.0007 cm-1 in the ground state, 0.0016 in (100) and (001), 0.0011 in (110) and (011) up to
/// J = 55 and Ka = 15, 0.003 in the overtones up to J = 40 and Ka = 14.
AsymmetricTop ozoneGround();         ///< (000)
AsymmetricTop ozoneBending();        ///< (010)
AsymmetricTop ozoneStretching();     ///< (100), (001)
AsymmetricTop ozoneBentStretching(); ///< (110), (011)
AsymmetricTop ozoneOvertones();      ///< (200), (101), (002)

/// Where the lines of ozone are generated, cm-1: around 9.6 and 4.75 um.
inline constexpr double ozoneFrom_per_cm = 983.0, ozoneTo_per_cm = 1275.0;
inline constexpr double ozoneOvertoneFrom_per_cm = 1630.0, ozoneOvertoneTo_per_cm = 2295.0;

/// The lines of these ranges: nu1 and nu3 with their hot bands from (010), (100) and (001), and
/// those of 16O16O18O and 16O18O16O as nu1 and nu3 of the main isotopologue moved to their origins
/// (to about 1 cm-1; J.-M. Flaud et al. 1990, Appl. Opt. 29, 3667, treat these bands); nu1 + nu2,
/// nu2 + nu3, 2 nu1, nu1 + nu3, 2 nu3, and nu1 + nu3 from (010). Widths are means over the lines of
/// `texts` (records of 160 columns) with the same lower J and Ka.
std::vector<Line> ozoneLines(const std::vector<std::string>& texts);

} // namespace irsg::lbl
