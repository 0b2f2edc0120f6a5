#pragma once

#include <string>
#include <vector>

namespace irsg {

/// A function given by nodes: linear between them, clamped outside, or periodic when `loop`
/// is set (period = last - first node, report section 8).
class LookupTable {
  public:
    LookupTable() = default;
    /// `x` strictly ascending and finite, at least one node; `y` finite and as many. A loop needs
    /// two nodes. Throws InputError naming the first node that breaks the rule, with `name` before
    /// it.
    LookupTable(std::vector<double> x, std::vector<double> y, bool loop = false,
                const std::string& name = "lookup table");

    const std::vector<double>& x() const { return x_; }
    const std::vector<double>& y() const { return y_; }
    bool loop() const { return loop_; }
    bool empty() const { return x_.empty(); }

    double at(double x) const;
    /// True where `at` holds an end value because x lies outside a table that does not loop.
    bool isOutside(double x) const;

    bool operator==(const LookupTable&) const = default;

  private:
    std::vector<double> x_;
    std::vector<double> y_;
    bool loop_ = false;
};

} // namespace irsg
