#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace irsg::lbl {

/// What nodes are chosen from: a matrix of training values, one column a candidate node, one row a
/// training case (a path's transmittance); and what a weighted sum over columns must give in each
/// row.
struct TrainingMatrix {
    std::size_t rows = 0;
    std::vector<float> columns;     ///< column by column
    std::vector<double> target;     ///< one a row
    std::vector<double> rowWeights; ///< >= 0; how much a row's error counts

    std::size_t columnCount() const { return rows == 0 ? 0 : columns.size() / rows; }
    std::span<const float> column(std::size_t i) const {
        return std::span(columns).subspan(i * rows, rows);
    }
};

struct NodeSelection {
    std::vector<std::size_t> columns; ///< ascending
    std::vector<double> weights;      ///< positive, sum 1
    double rmsError = 0.0;            ///< over rows, unweighted
    double largestError = 0.0;
};

/// How closely nodes must follow and how many there may be.
struct NodeGoals {
    double rms = 0.004;    ///< weighted by row
    double largest = 0.03; ///< of any row, not weighted
    std::size_t most = 6;
};

/// The fewest nodes, up to `most`, whose weighted sum comes as close to the target as the goals
/// want: nodes are added one at a time where they lower the error most and then exchanged as long
/// as that helps; weights are non-negative least squares with sum 1 (optimal spectral sampling,
/// Moncet et al. 2008, J. Atmos. Sci. 65, 3917).
NodeSelection selectNodes(const TrainingMatrix& training, const NodeGoals& goals);

} // namespace irsg::lbl
