#pragma once

#include <array>
#include <vector>

#include "irsg/atmosphere/engine/CrossSectionGrid.h"
#include "irsg/atmosphere/engine/GasTable.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/NodeSelection.h"
#include "tools/atmosphere-tables/lines/TrainingPaths.h"

namespace irsg::lbl {

/// ln of the cross sections (cm2) of every gas on a fine grid of wavenumbers, for each point of a
/// CrossSectionGrid; empty for a gas that does not absorb there.
struct FineCrossSections {
    WavenumberGrid grid;
    std::array<std::vector<std::vector<float>>, lineGasCount> lnCrossSection; ///< [gas][point][nu]
};

/// Nodes and bins of one interval of the spectrum.
struct TrainedNodes {
    std::vector<double> wavenumbers_per_cm;
    std::vector<GasTable::Block> blocks;  ///< nodes counted within this interval
    std::array<BinSet, 3> bins;           ///< likewise
    std::array<double, 3> squaredError{}; ///< summed over bins and paths, for an RMS
    std::array<double, 3> largestError{};
    std::array<std::size_t, 3> cases{};
};

/// Chooses the nodes of the bins of `baseWidth_per_cm` (1, 5 or 15) in [lower, upper), whole
/// multiples of 15 cm-1 apart, and out of these nodes those of the wider bins.
TrainedNodes trainNodes(const FineCrossSections& fine, const CrossSectionGrid& grid,
                        const TrainingPaths& training, double lower_per_cm, double upper_per_cm,
                        int baseWidth_per_cm, const std::array<NodeGoals, 3>& goals);

/// Computes the errors of nodes and bins that were trained before, whose nodes are points of the
/// fine grid.
void measureNodes(TrainedNodes& nodes, const FineCrossSections& fine, const CrossSectionGrid& grid,
                  const TrainingPaths& training);

} // namespace irsg::lbl
