#include "irsg/signature/random/SobolSequence.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"

namespace irsg {

namespace {

long costOf(int dimension, const std::array<std::uint32_t, 32>& v) {
    long sum = 0;
    for (int earlier = 0; earlier < dimension; ++earlier) {
        for (int m = 4; m <= 12; ++m) {
            const long t = sobolPairQuality(sobolDirections(earlier), v, m);
            sum += t * t;
        }
    }
    return sum;
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

TEST(SobolSequence, EveryCoordinateVisitsEveryCellOnce) {
    for (const bool scrambled : {false, true}) {
        const SobolSequence sequence(SobolSequence::mostDimensions, 7, 3);
        for (int d = 0; d < SobolSequence::mostDimensions; ++d) {
            std::set<int> cells;
            for (std::uint32_t i = 0; i < 256; ++i) {
                std::uint32_t bits = 0;
                for (unsigned k = 0; k < 8; ++k) {
                    if (i >> k & 1) {
                        bits ^= sobolDirections(d)[k];
                    }
                }
                const double x = scrambled ? sequence.at(i, d) : bits * 0x1p-32;
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
    EXPECT_EQ(sobolPairQuality(sobolDirections(0), sobolDirections(1), 8), 0);
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

TEST(SobolSequence, HoldsTheBestOfTheCandidatesOfTheSearch) {
    for (int dimension = 1; dimension <= 10; ++dimension) {
        const long kept = costOf(dimension, sobolDirections(dimension));
        for (int candidate = 0; candidate < 256; ++candidate) {
            ASSERT_LE(kept, costOf(dimension, sobolDirections(dimension, candidate))) << dimension;
        }
    }
}

TEST(SobolSequence, HasNoBadPairAmongItsFirstCoordinates) {
    // Without a search some pairs of these have t = 9 of 10.
    int worst = 0;
    for (int a = 0; a < 40; ++a) {
        for (int b = 0; b < a; ++b) {
            worst = std::max(worst, sobolPairQuality(sobolDirections(a), sobolDirections(b), 10));
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
