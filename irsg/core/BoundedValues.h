#pragma once

#include <optional>
#include <string>

namespace irsg {

/// How far a measured fraction may lie outside of 0 to 1 (a response outside of 0 to its largest
/// value, in that unit): instruments report 1.003 and -0.0002. What is within becomes the bound.
inline constexpr double boundTolerance = 0.005;

/// Brings values of a file that lie a little outside of their bounds to the bounds, and remembers
/// them for one remark.
class BoundedValues {
  public:
    /// `tolerance` in the unit of the values.
    BoundedValues(double least, double most, double tolerance = boundTolerance)
        : least_(least), most_(most), tolerance_(tolerance) {}

    /// The value, or the bound that it misses by no more than the tolerance; no value beyond that.
    /// `place` is where it stands: "line 3, column 2".
    std::optional<double> take(double value, const std::string& place);
    /// Says of `file` how many values became bounds, the first with its place, and the tolerance;
    /// nothing where none did.
    void remark(const std::string& file) const;

  private:
    double least_, most_, tolerance_;
    std::size_t count_ = 0;
    std::string first_;
};

} // namespace irsg
