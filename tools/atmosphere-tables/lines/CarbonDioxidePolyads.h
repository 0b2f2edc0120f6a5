#pragma once

#include <vector>

#include "tools/atmosphere-tables/lines/CarbonDioxideLevels.h"
#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// A vibrational state of CO2 as a mixture of harmonic ones, which Fermi resonance couples: those
/// with v1 = 0 ... `quanta` and v2 = 2 (quanta - v1) + l2.
struct PolyadState {
    int quanta = 0, l2 = 0, v3 = 0;
    int rank = 1;                   ///< r of HITRAN's v1 v2 l2 v3 r: 1 is the highest of its polyad
    double energy_per_cm = 0.0;     ///< above the ground state, without rotation
    double rotation_per_cm = 0.0;   ///< B
    std::vector<double> amplitudes; ///< by v1

    /// Energy of the level J, whose e and f components differ where l2 is 1.
    double level_per_cm(int J, char symmetry) const;
};

/// All states of a polyad of isotopologue 1 or 2 (LogicError otherwise), by rank. The constants are
/// fitted to the energies that the lines of HITRAN2016 and 2020 hold (E'' and E'' + nu): 223 states
/// of 12C16O2 to 9970 cm-1 with 0.12 cm-1 rms (0.5 at most), 93 of 13C16O2 to 8400 cm-1 with 0.4
/// cm-1 rms (1.9).
std::vector<PolyadState> carbonDioxidePolyad(int isotopologue, int quanta, int l2, int v3);

/// Strength of a band at 296 K, cm-1 / (molecule cm-2), natural abundance included: one dipole for
/// v3 + 1, two for v1 + 1 and v2 + 2 along with v3 + 1, in the harmonic states. They are fitted to
/// the strengths of Lamouroux et al. 2010, in whose list the bands that carry their polyad's
/// strength are met to 6 percent. 0 for other bands.
double polyadBandStrength(int isotopologue, const PolyadState& upper, const PolyadState& lower);

/// Lines around 4.3 and 2.7 um of all bands of isotopologues 1 and 2 from levels below
/// `highestEnergy_per_cm`, those left out that are weaker than `weakest` at `temperature_K` (both
/// as intensities at that temperature). Positions to 0.5 cm-1, which a narrow band does not
/// resolve. Intensities are those at 296 K, however small. Ascending.
std::vector<Line> hotCarbonDioxide(const CarbonDioxideLevels& levels, double highestEnergy_per_cm,
                                   double temperature_K, double weakest);

/// Adds to a list the hot lines that it lacks: a hot line is listed where one of its isotopologue
/// lies within 1 cm-1, with E'' within 6 cm-1 and strength within 40 percent, and stands for no
/// other.
void addMissingLines(LineList& list, const std::vector<Line>& hot);

} // namespace irsg::lbl
