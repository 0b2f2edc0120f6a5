#pragma once

#include <cstddef>

namespace irsg {

/// Sums over nodes go block by block, so that what many sums share stays in the first cache. The
/// loops below are written eight wide: the partial sums of a sum do not wait for each other, and
/// their order is the same on every machine.
inline constexpr std::size_t nodesOfBlock = 256;

/// values[i] = make(i).
template <typename Make>
void fillBlock(double* values, std::size_t count, const Make& make) {
    constexpr std::size_t width = 8;
    std::size_t i = 0;
    for (; i + width <= count; i += width) {
        double made[width];
        for (std::size_t k = 0; k < width; ++k)
            made[k] = make(i + k);
        for (std::size_t k = 0; k < width; ++k)
            values[i + k] = made[k];
    }
    for (; i < count; ++i)
        values[i] = make(i);
}

} // namespace irsg
