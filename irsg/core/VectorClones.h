#pragma once

#include <array>
#include <cstddef>

/// Before a function with long loops: it is compiled for the vectors of newer processors too, and
/// the program takes the widest that its processor has. Files that use it are compiled without
/// contraction of products and sums (CMakeLists.txt), so all versions give the same bits.
/// Sanitizers, which cannot run before a program starts, get the plain version.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define IRSG_VECTOR_CLONES [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define IRSG_VECTOR_CLONES
#endif

namespace irsg {

/// Sums that ran side by side, added by halves, so that none waits for more than four others.
template <typename Number, std::size_t count>
inline double sumOf(std::array<Number, count> sums) {
    for (std::size_t half = count / 2; half > 0; half /= 2)
        for (std::size_t k = 0; k < half; ++k)
            sums[k] += sums[k + half];
    return static_cast<double>(sums[0]);
}

} // namespace irsg
