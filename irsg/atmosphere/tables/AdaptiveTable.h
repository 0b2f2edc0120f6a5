#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace irsg {

/// A function of one variable whose values are vectors (a spectrum, answers of wideband-ck), kept
/// at points and linear between them. Points are added where values are asked for, by halving,
/// until the function at the middles of both halves of a cell differs from the straight line over
/// the half by no more than a tolerance; the cell is then used in quarters, over which a smooth
/// function's error is a fourth of what was measured.
///
/// Const members may be called from several threads.
class AdaptiveTable {
  public:
    using Values = std::vector<double>;
    using Function = std::function<Values(double)>;
    /// How wrong a straight line from one value to another may be, in the unit of the tolerance,
    /// where `found` is the function halfway; see `halfway`.
    using Distance =
        std::function<double(const Values& found, const Values& from, const Values& to)>;

    /// Over low to high, low < high (LogicError otherwise). Cells are not made smaller than
    /// (high - low) / 2^30.
    AdaptiveTable(double low, double high, double tolerance, Function function, Distance distance);

    /// Interpolated; computed where the table cannot be refined to its tolerance. LogicError
    /// outside.
    Values at(double x) const;

    std::size_t evaluations() const; ///< of the function, until now
    std::size_t bytes() const;       ///< of what is kept
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
    mutable int queries_ = 0; ///< that were answered without cells
    mutable std::size_t evaluations_ = 0;
    mutable double largestError_ = 0.0;
};

/// The distance of the function from the middle of the line.
AdaptiveTable::Distance halfway(double (*difference)(const std::vector<double>&,
                                                     const std::vector<double>&));
/// The largest difference of two elements.
double largestDifference(const std::vector<double>& a, const std::vector<double>& b);
/// Sum of differences relative to the sum of the first's absolute values (0 for two zeros).
double relativeDifference(const std::vector<double>& a, const std::vector<double>& b);

} // namespace irsg
