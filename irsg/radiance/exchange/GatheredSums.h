#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "irsg/core/ParallelFor.h"

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

    /// Calls begin(i, sums) for the numbers below `count`, which returns what the i-th gathers and
    /// may set the sums, 0 before, that it is added to; then take(i, sums); on all cores.
    template <typename Begin, typename Take>
    void forEach(std::size_t count, Begin begin, Take take) const {
        parallelForSmall((count + together - 1) / together, [&](std::uint32_t block) {
            const std::size_t first = block * together;
            const std::size_t own = std::min(together, count - first);
            std::array<std::span<const float>, together> gathered;
            thread_local std::vector<double> sums;
            sums.assign(kinds_ * together, 0.0);
            const auto sumsOf = [&](std::size_t i) {
                return std::span(sums).subspan(i * kinds_, kinds_);
            };
            for (std::size_t i = 0; i < own; ++i)
                gathered[i] = begin(first + i, sumsOf(i));
            add(gathered, sums);
            for (std::size_t i = 0; i < own; ++i)
                take(first + i, std::span<const double>(sumsOf(i)));
        });
    }

  private:
    static constexpr std::size_t lanes = 4; ///< kinds at a time
    std::size_t kinds_, count_;
    std::vector<double> interleaved_; // lanes of a place, place by place, then the next kinds
};

} // namespace irsg
