#include "irsg/signature/random/SobolSequence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"

namespace irsg {

namespace {

using Directions = std::array<std::uint32_t, 32>;

/// Rows of bits that are linearly independent over GF(2).
class RowSpace {
  public:
    /// False where the row is a sum of those that there are.
    bool add(std::uint32_t row) {
        while (row != 0) {
            auto& pivot = basis_[static_cast<std::size_t>(std::bit_width(row) - 1)];
            if (pivot == 0) {
                pivot = row;
                return true;
            }
            row ^= pivot;
        }
        return false;
    }

  private:
    std::array<std::uint32_t, 32> basis_{}; // by leading bit
};

/// t-value of the first 2^m points of two coordinates: of every elementary interval of volume
/// 2^(t - m) as many points lie inside as its volume asks for. 0 is best, m is worst.
int pairQuality(const Directions& first, const Directions& second, int m) {
    // Row i of a generator matrix holds bit 31 - i of the first m direction numbers.
    const auto row = [m](const Directions& v, int i) {
        std::uint32_t bits = 0;
        for (int k = 0; k < m; ++k) {
            bits |= (v[static_cast<std::size_t>(k)] >> (31 - i) & 1) << k;
        }
        return bits;
    };
    std::array<std::uint32_t, 32> rows1{}, rows2{};
    for (int i = 0; i < m; ++i) {
        rows1[static_cast<std::size_t>(i)] = row(first, i);
        rows2[static_cast<std::size_t>(i)] = row(second, i);
    }

    // d1 rows of the one and as many of the other as stay linearly independent.
    int strength = m;
    for (int d1 = 0; d1 <= m; ++d1) {
        RowSpace rows;
        int count = 0;
        for (int i = 0; i < d1 && rows.add(rows1[static_cast<std::size_t>(i)]); ++i) {
            ++count;
        }
        for (int i = 0; i < m - d1 && rows.add(rows2[static_cast<std::size_t>(i)]); ++i) {
            ++count;
        }
        strength = std::min(strength, count);
    }
    return m - strength;
}

/// The 32 digits of a coordinate before they are scrambled.
std::uint32_t digitsOf(std::uint32_t index, int dimension) {
    std::uint32_t bits = 0;
    for (unsigned k = 0; k < 32; ++k) {
        if (index >> k & 1) {
            bits ^= sobolDirections(dimension)[k];
        }
    }
    return bits;
}

} // namespace

TEST(SobolSequence, BeginsAsSobolPublishedIt) {
    // Van der Corput's sequence, and x + 1 with m_1 = 1: 1, 3, 5, 15, 17, 51 ... over powers of 2.
    const auto& v = sobolDirections(1);
    const std::uint32_t m[] = {1, 3, 5, 15, 17, 51, 85, 255};
    for (unsigned k = 0; k < 8; ++k) {
        EXPECT_EQ(sobolDirections(0)[k], 1u << (31 - k));
        EXPECT_EQ(v[k], m[k] << (31 - k));
    }
}

TEST(SobolSequence, HasTheInitialNumbersThatJoeAndKuoPublished) {
    // Lines of new-joe-kuo-6.21201: coordinate (from 1), degree s, inner coefficients a of the
    // primitive polynomial, initial numbers m.
    const struct {
        int coordinate, s;
        std::uint32_t a;
        std::vector<std::uint32_t> m;
    } lines[] = {
        {2, 1, 0, {1}},
        {3, 2, 1, {1, 3}},
        {4, 3, 1, {1, 3, 1}},
        {5, 3, 2, {1, 1, 1}},
        {6, 4, 1, {1, 1, 3, 3}},
        {7, 4, 4, {1, 3, 5, 13}},
        {8, 5, 2, {1, 1, 5, 5, 17}},
        {9, 5, 4, {1, 1, 5, 5, 5}},
        {10, 5, 7, {1, 1, 7, 11, 19}},
        {128, 10, 242, {1, 3, 3, 7, 5, 41, 127, 61, 261, 717}},
    };
    for (const auto& line : lines) {
        std::vector<std::uint64_t> m(line.m.begin(), line.m.end());
        // Their recurrence.
        for (auto k = static_cast<std::size_t>(line.s); k < 32; ++k) {
            const auto s = static_cast<std::size_t>(line.s);
            m.push_back(m[k - s] ^ m[k - s] << s);
            for (std::size_t i = 1; i < s; ++i) {
                if (line.a >> (s - 1 - i) & 1) {
                    m.back() ^= m[k - i] << i;
                }
            }
        }
        for (std::size_t k = 0; k < 32; ++k) {
            EXPECT_EQ(sobolDirections(line.coordinate - 1)[k], m[k] << (31 - k))
                << line.coordinate << " " << k;
        }
    }
}

TEST(SobolSequence, HasThePointsThatSciPyMakes) {
    // scipy.stats.qmc.Sobol(d=128, scramble=False, bits=32) of SciPy 1.17.1, which counts in Gray
    // code: its point n is point n ^ (n >> 1) here. Coordinates 0, 1, 2, 3, 7, 20, 63 and 127 times
    // 2^32.
    const int coordinates[] = {0, 1, 2, 3, 7, 20, 63, 127};
    const struct {
        std::uint32_t n;
        std::array<std::uint32_t, 8> digits;
    } points[] = {
        {0,
         {0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u,
          0x00000000u}},
        {1,
         {0x80000000u, 0x80000000u, 0x80000000u, 0x80000000u, 0x80000000u, 0x80000000u, 0x80000000u,
          0x80000000u}},
        {2,
         {0xc0000000u, 0x40000000u, 0x40000000u, 0x40000000u, 0xc0000000u, 0x40000000u, 0xc0000000u,
          0x40000000u}},
        {3,
         {0x40000000u, 0xc0000000u, 0xc0000000u, 0xc0000000u, 0x40000000u, 0xc0000000u, 0x40000000u,
          0xc0000000u}},
        {4,
         {0x60000000u, 0x60000000u, 0xa0000000u, 0xe0000000u, 0xe0000000u, 0x20000000u, 0x20000000u,
          0xa0000000u}},
        {5,
         {0xe0000000u, 0xe0000000u, 0x20000000u, 0x60000000u, 0x60000000u, 0xa0000000u, 0xa0000000u,
          0x20000000u}},
        {6,
         {0xa0000000u, 0x20000000u, 0xe0000000u, 0xa0000000u, 0x20000000u, 0x60000000u, 0xe0000000u,
          0xe0000000u}},
        {7,
         {0x20000000u, 0xa0000000u, 0x60000000u, 0x20000000u, 0xa0000000u, 0xe0000000u, 0x60000000u,
          0x60000000u}},
        {12,
         {0x50000000u, 0x30000000u, 0x50000000u, 0x90000000u, 0x10000000u, 0x10000000u, 0x90000000u,
          0xb0000000u}},
        {100,
         {0x6a000000u, 0x42000000u, 0xc6000000u, 0xba000000u, 0x7a000000u, 0xc2000000u, 0xa6000000u,
          0x76000000u}},
        {777,
         {0xb1400000u, 0xefc00000u, 0x29c00000u, 0x46400000u, 0xc3400000u, 0x3cc00000u, 0x6d400000u,
          0x1e400000u}},
        {4095,
         {0x00100000u, 0xf0f00000u, 0x55900000u, 0xe6d00000u, 0x64100000u, 0x39d00000u, 0x8db00000u,
          0x42f00000u}},
        {8000,
         {0x07080000u, 0x11880000u, 0x97680000u, 0x3d080000u, 0xa9280000u, 0x72f80000u, 0x5aa80000u,
          0x26780000u}},
    };
    for (const auto& point : points) {
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_EQ(digitsOf(point.n ^ point.n >> 1, coordinates[i]), point.digits[i])
                << point.n << " " << coordinates[i];
        }
    }
}

TEST(SobolSequence, HasSobolsPropertyA) {
    // Of the first 2^d points in d dimensions one lies in each of the 2^d parts that come of
    // halving all coordinates: the leading bits of the direction numbers are independent.
    for (int d = 1; d <= 32; ++d) {
        RowSpace rows;
        for (int coordinate = 0; coordinate < d; ++coordinate) {
            std::uint32_t row = 0;
            for (unsigned k = 0; k < static_cast<unsigned>(d); ++k) {
                row |= (sobolDirections(coordinate)[k] >> 31) << k;
            }
            EXPECT_TRUE(rows.add(row)) << d << " " << coordinate;
        }
    }
}

TEST(SobolSequence, EveryCoordinateVisitsEveryCellOnce) {
    for (const bool scrambled : {false, true}) {
        const SobolSequence sequence(SobolSequence::mostDimensions, 7, 3);
        for (int d = 0; d < SobolSequence::mostDimensions; ++d) {
            std::set<int> cells;
            for (std::uint32_t i = 0; i < 256; ++i) {
                const double x = scrambled ? sequence.at(i, d) : digitsOf(i, d) * 0x1p-32;
                ASSERT_GE(x, 0.0);
                ASSERT_LT(x, 1.0);
                cells.insert(static_cast<int>(256.0 * x));
            }
            EXPECT_EQ(cells.size(), 256u) << "coordinate " << d;
        }
    }
}

TEST(SobolSequence, KeepsItsNetWhenScrambled) {
    // The first two coordinates are a (0, 2)-sequence: one point in every elementary interval.
    EXPECT_EQ(pairQuality(sobolDirections(0), sobolDirections(1), 8), 0);
    const SobolSequence sequence(2, 11, 0);
    for (int d1 = 0; d1 <= 8; ++d1) {
        std::set<int> cells;
        for (std::uint32_t i = 0; i < 256; ++i) {
            cells.insert(static_cast<int>(std::ldexp(sequence.at(i, 0), d1)) * 1000 +
                         static_cast<int>(std::ldexp(sequence.at(i, 1), 8 - d1)));
        }
        EXPECT_EQ(cells.size(), 256u) << d1;
    }
}

TEST(SobolSequence, HasNoBadPairAmongItsFirstCoordinates) {
    // What Joe and Kuo searched for; numbers that are drawn at random have t = 9 of 10 in some
    // pairs.
    int worst = 0;
    for (int a = 0; a < 40; ++a) {
        for (int b = 0; b < a; ++b) {
            worst = std::max(worst, pairQuality(sobolDirections(a), sobolDirections(b), 10));
        }
    }
    EXPECT_LE(worst, 6);
}

TEST(SobolSequence, IntegratesBetterThanPlainDrawsInManyDimensions) {
    // Product of 1 + (x - 1/2) / (j + 1)^2, whose integral is 1, over 30 coordinates.
    constexpr int dimensions = 30;
    constexpr std::uint32_t points = 1024;
    const auto meanOf = [&](auto coordinate) {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < points; ++i) {
            double product = 1.0;
            for (int d = 0; d < dimensions; ++d) {
                product *= 1.0 + (coordinate(i, d) - 0.5) / ((d + 1.0) * (d + 1.0));
            }
            sum += product;
        }
        return sum / points;
    };
    double sobol = 0.0, plain = 0.0;
    for (std::uint32_t replicate = 0; replicate < 16; ++replicate) {
        const SobolSequence sequence(dimensions, 1, replicate);
        sobol +=
            std::pow(meanOf([&](std::uint32_t i, int d) { return sequence.at(i, d); }) - 1.0, 2);
        plain += std::pow(meanOf([&](std::uint32_t i, int d) {
                              return unitOf(1, {7, replicate, d}, i);
                          }) - 1.0,
                          2);
    }
    EXPECT_LT(std::sqrt(sobol / plain), 0.02);
}

TEST(SobolSequence, ReplicatesAreIndependentAndSeedsRepeat) {
    const SobolSequence a(3, 5, 0), again(3, 5, 0), b(3, 5, 1), c(3, 6, 0);
    EXPECT_EQ(a.at(77, 2), again.at(77, 2));
    EXPECT_NE(a.at(77, 2), b.at(77, 2));
    EXPECT_NE(a.at(77, 2), c.at(77, 2));
    EXPECT_THROW(SobolSequence(129, 1, 0), LogicError);
    EXPECT_THROW(SobolSequence(0, 1, 0), LogicError);
}

} // namespace irsg
