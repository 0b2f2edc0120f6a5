#pragma once

#include <vector>

#include "irsg/atmosphere/engine/Profile.h"

namespace irsg::lbl {

/// A layer of one training atmosphere, uniform.
struct TrainingLayer {
    AtmosphericState air;
    double thickness_m = 0.0;
};

/// A path through consecutive layers of one atmosphere: `factor` times the vertical path through
/// layers `first` to `last` - 1. Horizontal paths go through one layer.
struct TrainingPath {
    std::size_t first = 0, last = 0; ///< into TrainingPaths::layers
    double factor = 1.0;
};

/// The paths on which spectral nodes are trained, in every atmosphere: horizontal from 10 m to 80
/// km at seven altitudes and to 250 km from 8 km up, slant between levels, from the ground to space
/// and from space down, up to 12 times the vertical.
struct TrainingPaths {
    std::vector<TrainingLayer> layers; ///< atmosphere by atmosphere, from the ground up
    std::vector<TrainingPath> paths;
    std::vector<std::size_t> sorting; ///< layers by whose absorption candidates are picked
};

TrainingPaths trainingPaths(const std::vector<Profile>& atmospheres);

} // namespace irsg::lbl
