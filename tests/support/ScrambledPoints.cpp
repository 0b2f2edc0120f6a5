#include "tests/support/ScrambledPoints.h"

namespace irsg::test::tracing {

ScrambledPoints::ScrambledPoints(std::uint64_t seed) {
    // Primitive polynomials and first direction numbers, Joe and Kuo 2008.
    struct Start {
        unsigned degree, inner;
        std::array<std::uint32_t, 5> first;
    };
    static constexpr std::array<Start, dimensions - 1> starts{{{1, 0, {1}},
                                                               {2, 1, {1, 3}},
                                                               {3, 1, {1, 3, 1}},
                                                               {3, 2, {1, 1, 1}},
                                                               {4, 1, {1, 1, 3, 3}},
                                                               {4, 4, {1, 3, 5, 13}},
                                                               {5, 2, {1, 1, 5, 5, 17}},
                                                               {5, 4, {1, 1, 5, 5, 5}},
                                                               {5, 7, {1, 1, 7, 11, 19}}}};
    Words words(seed);
    for (std::size_t d = 0; d < dimensions; ++d) {
        std::array<std::uint32_t, 32> numbers{};
        for (unsigned i = 0; i < 32; ++i) {
            if (d == 0) {
                numbers[i] = 1u << (31 - i);
                continue;
            }
            const Start& start = starts[d - 1];
            if (i < start.degree) {
                numbers[i] = start.first[i] << (31 - i);
                continue;
            }
            std::uint32_t number = numbers[i - start.degree] >> start.degree;
            number ^= numbers[i - start.degree];
            for (unsigned k = 1; k < start.degree; ++k) {
                if ((start.inner >> (start.degree - 1 - k)) & 1u) {
                    number ^= numbers[i - k];
                }
            }
            numbers[i] = number;
        }
        std::array<std::uint32_t, 32> rows{};
        for (unsigned row = 0; row < 32; ++row) {
            const std::uint32_t own = 1u << (31 - row);
            const auto random = static_cast<std::uint32_t>(words.next() >> 32);
            rows[row] = own | (random & ~(own | (own - 1u)));
        }
        for (unsigned i = 0; i < 32; ++i) {
            for (unsigned row = 0; row < 32; ++row) {
                if (std::popcount(rows[row] & numbers[i]) & 1) {
                    numbers_[d][i] |= 1u << (31 - row);
                }
            }
        }
        shift_[d] = static_cast<std::uint32_t>(words.next() >> 32);
    }
}

} // namespace irsg::test::tracing
