#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace irsg {

/// atan2 for every pixel of a frame: from a table, to 1e-7 rad.
class FastAngle {
  public:
    FastAngle() {
        for (std::size_t i = 0; i < table_.size(); ++i)
            table_[i] = std::atan(static_cast<double>(i) / cells);
    }
    double operator()(double y, double x) const {
        const double ax = std::abs(x), ay = std::abs(y);
        const bool steep = ay > ax;
        const double longer = steep ? ay : ax;
        if (longer == 0.0)
            return 0.0;
        const double at = (steep ? ax : ay) / longer * cells;
        const auto cell = static_cast<std::size_t>(static_cast<int>(at));
        double angle =
            table_[cell] + (at - static_cast<double>(cell)) * (table_[cell + 1] - table_[cell]);
        if (steep)
            angle = 0.5 * std::numbers::pi - angle;
        if (x < 0.0)
            angle = std::numbers::pi - angle;
        return y < 0.0 ? -angle : angle;
    }

  private:
    static constexpr int cells = 1024;
    std::array<double, cells + 2> table_;
};

} // namespace irsg
