#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace irsg {

/// Numbers that are put together: each set goes by its lowest.
class JoinedNumbers {
  public:
    explicit JoinedNumbers(std::size_t count) : lower_(count) {
        std::iota(lower_.begin(), lower_.end(), 0u);
    }
    std::uint32_t of(std::uint32_t number) {
        while (lower_[number] != number)
            number = lower_[number] = lower_[lower_[number]];
        return number;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        lower_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> lower_;
};

} // namespace irsg
