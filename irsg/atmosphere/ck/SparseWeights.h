#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// A linear problem whose solution shall be sparse: weights w >= 0 with matrix * w = target, most
/// of them 0. A column is a candidate for a quadrature point.
struct SparseProblem {
    std::size_t columnCount = 0;
    std::vector<float> matrix; ///< row by row
    std::vector<double> target;

    std::size_t rows() const { return target.size(); }
    const float* row(std::size_t r) const { return matrix.data() + r * columnCount; }
};

struct SparseWeights {
    std::vector<std::size_t> columns; ///< ascending
    std::vector<double> weights;      ///< positive
    double largestError = 0.0;        ///< largest |matrix w - target|
    double rmsError = 0.0;
};

/// Few columns for a largest error. Non-negative least squares (Lawson and Hanson 1974, chapter
/// 23): columns are added where the residual falls fastest, some at once that are not neighbours,
/// while rows with large errors are given more and more importance, which leads to the least
/// largest error (Lawson's iteration, Rice and Usow 1968, Math. Comp. 22, 118). Stops when no row's
/// error is above `largestError`, when `most` columns are in use or when nothing improves. Then
/// those that matter least are taken out again, some at once, as long as the error stays within the
/// bound. All of it sees a hundred rows, then also those that the columns so found miss most, with
/// an error that falls to the bound meanwhile, until they hold for every row: rows of one path and
/// its neighbours say nearly the same.
SparseWeights sparseWeights(const SparseProblem& problem, double largestError, std::size_t most);

} // namespace irsg
