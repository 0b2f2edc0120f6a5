#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace irsg {

/// A function of one variable whose values are vectors (a spectrum, wideband terms), kept at points
/// and linear between them. Points are added where values are asked for, by halving, until the
/// function at the middles of both halves of a cell differs from the straight line over the half by
/// no more than a tolerance; the cell is then used in quarters, over which a smooth function's
/// error is a fourth of what was measured.
///
/// Const members may be called from several threads.
class AdaptiveTable {
  public:
    using Values = std::vector<double>;
    using Function = std::function<Values(double)>;
    /// How far a value is from another, in the unit of the tolerance.
    using Distance = std::function<double(const Values& found, const Values& interpolated)>;

    /// Over low to high, low < high (LogicError otherwise). Cells are not made smaller than
    /// (high - low) / 2^30.
    AdaptiveTable(double low, double high, double tolerance, Function function, Distance distance);

    /// Interpolated; computed where the table cannot be refined to its tolerance. LogicError
    /// outside.
    Values at(double x) const;

    std::size_t evaluations() const; ///< of the function, until now
    /// The largest distance measured in a cell that is used for interpolation; 0 before any.
    double largestError() const;

  private:
    struct Cell {
        bool tested = false, good = false;
    };
    const Values& value(double x) const;

    double low_, high_, tolerance_;
    Function function_;
    Distance distance_;
    mutable std::mutex mutex_;
    mutable std::map<double, Values> values_;
    mutable std::map<std::pair<double, double>, Cell> cells_;
    mutable int questions_ = 0; ///< that were answered without cells
    mutable std::size_t evaluations_ = 0;
    mutable double largestError_ = 0.0;
};

/// The largest difference of two elements.
double largestDifference(const std::vector<double>& a, const std::vector<double>& b);
/// Sum of differences relative to the sum of the first's absolute values (0 for two zeros).
double relativeDifference(const std::vector<double>& a, const std::vector<double>& b);

} // namespace irsg
