#pragma once

#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Species of a level in the group of the tetrahedron.
enum class TetrahedralSpecies { A1, A2, E, F1, F2 };

/// A level of 12CH4. Of levels that are degenerate by symmetry one component is there, of E two:
/// one in each of the blocks 0 and 2, functions that a quarter turn with reflection about z leaves
/// as they are or reverses.
struct TetrahedralLevel {
    double energy_per_cm = 0.0;
    int J = 0;
    TetrahedralSpecies species = TetrahedralSpecies::A1;
    int number = 1; ///< of its J and species, from 1 on, by energy (HITRAN's)
    int block = 0;
    std::vector<double> amplitudes; ///< of vibrational function v and k, at v (2J + 1) + J + k
};

/// The ground state. Constants fitted to the lower energies of HITRAN's lines (rms 0.003 cm-1 up to
/// J = 17).
std::vector<TetrahedralLevel> methaneGround(int J);

/// nu4 and nu2, which interact (the dyad). Vibrational functions: l = -1, 0, 1 of nu4, then the two
/// of nu2. Effective Hamiltonian with operators up to the fourth degree in J, as J.-P. Champion et
/// al. 1992 have it (Spectroscopy of the Earth's Atmosphere and Interstellar Medium, 339), its
/// constants fitted to energies that HITRAN's list holds as lower levels of hot bands and as sums
/// of position and lower energy: rms 0.012 cm-1 up to J = 16, at most 0.06.
std::vector<TetrahedralLevel> methaneDyad(int J);

/// Where the lines of methane are generated, cm-1.
inline constexpr double methaneDyadFrom_per_cm = 1200.0, methaneDyadTo_per_cm = 1775.0;

/// Lines of nu4 and nu2 in a range, of 12CH4 and, moved by the distance of their origins, of 13CH4.
/// One dipole, that of nu4, with
/// the factor of Herman and Wallis that its P branch below the range has; nu2 borrows from it.
/// Widths are means over the lines of `listed` with the same lower J, which their lower energy
/// tells.
std::vector<Line> methaneDyadLines(const std::vector<Line>& listed,
                                   double from_per_cm = methaneDyadFrom_per_cm,
                                   double to_per_cm = methaneDyadTo_per_cm);

} // namespace irsg::lbl
