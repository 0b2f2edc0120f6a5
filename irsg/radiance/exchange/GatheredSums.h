#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace irsg {

/// Sums of what receivers gather times the integrals of several kinds, or outputs. Each sum is made
/// in the order of the gathered numbers, whatever is made beside it; several receivers and kinds
/// at once, so that processors do not wait for the last addition.
class GatheredSums {
  public:
    /// Receivers at a time.
    static constexpr std::size_t together = 4;

    /// `integrals`: of each kind as many; those from `first` on belong to what is gathered.
    GatheredSums(const std::vector<std::span<const double>>& integrals, std::size_t first);

    /// Adds to `sums`, receiver by receiver a number for each kind, what they gather; an empty one
    /// gathers nothing.
    void add(const std::array<std::span<const float>, together>& gathered,
             std::span<double> sums) const;

  private:
    static constexpr std::size_t lanes = 4; ///< kinds at a time
    std::size_t kinds_, count_;
    std::vector<double> interleaved_; // lanes of a place, place by place, then the next kinds
};

} // namespace irsg
