#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace irsg {

/// Sums over nodes go block by block, so that what many sums share stays in the first cache. The
/// loops below are written eight wide: the strands of a sum do not wait for each other, and their
/// order is the same on every machine.
inline constexpr std::size_t nodesOfBlock = 256;

/// Sum of a[i] b[i].
inline double sumOfProducts(const double* a, const double* b, std::size_t count) {
    using Two = double __attribute__((vector_size(2 * sizeof(double))));
    const auto product = [=](std::size_t i) {
        Two of, by;
        std::memcpy(&of, a + i, sizeof of);
        std::memcpy(&by, b + i, sizeof by);
        return of * by;
    };
    Two sums[4] = {};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        sums[0] += product(i);
        sums[1] += product(i + 2);
        sums[2] += product(i + 4);
        sums[3] += product(i + 6);
    }
    for (; i < count; ++i)
        sums[0][0] += a[i] * b[i];
    const Two sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    return sum[0] + sum[1];
}

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
