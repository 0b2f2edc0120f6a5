#pragma once

#include <cmath>

namespace irsg {

/// Neumaier's compensated sum (Z. angew. Math. Mech. 54, 39, 1974): the error does not grow with
/// the number of terms.
class CompensatedSum {
  public:
    void add(double value) {
        const double next = sum_ + value;
        lost_ += std::abs(sum_) >= std::abs(value) ? (sum_ - next) + value : (value - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + lost_; }

  private:
    double sum_ = 0.0, lost_ = 0.0;
};

} // namespace irsg
