#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// A rotational line of the main isotopologue 14N2-16O with what is needed to move it.
struct AssignedLine {
    Line line;
    int m = 0; ///< J'' + 1 in the R branch, -J'' in the P branch, 0 in the Q branch
    int J = 0; ///< of the lower level
};

/// A rarer isotopologue of a linear molecule beside the main one.
struct RareIsotopologue {
    int number = 2;                   ///< HITRAN's
    double abundanceRatio = 0.0;      ///< to the main one
    double origin_per_cm = 0.0;       ///< of the band
    double rotation_per_cm = 0.0;     ///< B of the lowest state
    double mainOrigin_per_cm = 0.0;   ///< of the main one
    double mainRotation_per_cm = 0.0; ///< B'' of it
    double mainSum_per_cm = 0.0;      ///< B' + B'' of it
    double mainChange_per_cm = 0.0;   ///< B' - B'' of it, negative
};

/// The same line of another isotopologue: with m as above and r = B / B(main) its position moves by
/// the distance of the band origins, (r - 1)(B' + B'') m and (q - 1)(B' - B'') m^2 where q = r^2
/// origin(main) / origin, as the vibrational change of B goes with B^2 / frequency; its lower
/// energy by (r - 1) B J (J + 1); its strength with the abundance, the population of the level and
/// the partition sum of a rigid rotor. Widths stay.
Line movedLine(const AssignedLine& of, const RareIsotopologue& to);

/// The lines of 14N15N16O, 15N14N16O, 14N14N18O and 14N14N17O in the nu3 region, 2000 to 2400 cm-1,
/// where the list has the main one alone: the bands of the main one that raise v3 by 1, moved.
/// Origins and B of the isotopologues: R. A. Toth 1987 (J. Opt. Soc. Am. B 4, 357) and M. Bogey
/// 1975 as in NIST's tables of triatomic molecules; abundances of HITRAN. `texts`: records of 160
/// columns with quanta.
std::vector<Line> rareNitrousOxide(const std::vector<std::string>& texts);

/// Lines of a record list whose vibrational states are such: v1 v2 l2 v3 with blanks between.
/// Without a predicate on bands: those that raise v3 by 1.
std::vector<AssignedLine> assignedLines(const std::vector<std::string>& texts, int isotopologue,
                                        double lower_per_cm, double upper_per_cm);

} // namespace irsg::lbl
