#pragma once

#include <array>
#include <vector>

#include "tools/atmosphere-tables/lines/NodeTraining.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace smat::tables {

/// An interval of the spectrum that is worked on at once.
struct Piece {
    double lower_per_cm = 0.0, upper_per_cm = 0.0;
    int width_per_cm = 1;       ///< of the narrowest bins
    double step_per_cm = 0.001; ///< of the line-by-line grid
};

/// The grid of pressures and temperatures of gases.gastable.
irsg::CrossSectionGrid crossSectionGrid();
/// How closely the nodes of bins of 1, 5 and 15 cm-1 must follow line by line.
std::array<irsg::lbl::NodeGoals, 3> nodeGoals();
/// The six model atmospheres, in which nodes are trained.
std::vector<irsg::Profile> modelAtmospheres();
/// Every gas's cross sections line by line on a fine grid over a piece of the spectrum.
irsg::lbl::FineCrossSections fineCrossSections(const std::vector<irsg::lbl::LineList>& gases,
                                               const irsg::lbl::PartitionSums& partition,
                                               const irsg::CrossSectionGrid& grid,
                                               const Piece& piece);

} // namespace smat::tables
