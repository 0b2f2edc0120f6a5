#include "irsg/signature/Distribution.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

#include <boost/math/distributions.hpp>
#include <boost/math/quadrature/ooura_fourier_integrals.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/signature/random/Philox.h"
#include "tests/support/Refusal.h"

namespace irsg {

namespace {

using Kind = DistributionKind;
using testing::HasSubstr;

/// P(X <= x) and P(X > x) of the distribution before it is truncated, by Boost.Math.
struct Reference {
    std::function<double(double)> lower, upper;
};

template <typename Law>
Reference referenceOf(Law law, double origin, double scale) {
    const auto [first, last] = support(law);
    const auto within = [=](double x) { return std::clamp((x - origin) / scale, first, last); };
    return {[=](double x) { return cdf(law, within(x)); },
            [=](double x) { return cdf(complement(law, within(x))); }};
}

/// The symmetric stable distribution from its characteristic function, e^(-|t|^alpha).
Reference symmetricStable(double alpha, double origin, double scale) {
    const auto integrator = std::make_shared<boost::math::quadrature::ooura_fourier_sin<double>>();
    const auto lower = [=](double x) {
        const double z = (x - origin) / scale;
        const auto f = [alpha](double t) { return std::exp(-std::pow(t, alpha)) / t; };
        const double half = integrator->integrate(f, std::abs(z)).first / 3.14159265358979324;
        return z > 0.0 ? 0.5 + half : 0.5 - half;
    };
    return {lower, [=](double x) { return 1.0 - lower(x); }};
}

/// What the sum of two uniform distributions has whose half-widths are (1 + top)/4 and (1 - top)/4.
Reference trapezoid(double top, double origin, double scale) {
    const double wide = 0.25 * (1.0 + top), narrow = 0.25 * (1.0 - top);
    const auto lower = [=](double x) {
        const double z = (x - origin) / scale - 0.5;
        if (narrow == 0.0) {
            return std::clamp(z + 0.5, 0.0, 1.0);
        }
        const auto square = [](double y) { return y > 0.0 ? y * y : 0.0; };
        return (square(z + wide + narrow) - square(z + wide - narrow) - square(z - wide + narrow) +
                square(z - wide - narrow)) /
               (8.0 * wide * narrow);
    };
    return {lower, [=](double x) { return lower(2.0 * origin + scale - x); }};
}

Reference referenceOf(Kind kind, const std::vector<double>& p, double min, double max) {
    namespace bm = boost::math;
    switch (kind) {
    case Kind::uniform:
        return referenceOf(bm::uniform(min, max), 0.0, 1.0);
    case Kind::normal:
        return referenceOf(bm::normal(), p[0], p[1]);
    case Kind::exponential:
        return referenceOf(bm::exponential(), p[0], p[1]);
    case Kind::laplace:
        return referenceOf(bm::laplace(), p[0], p[1]);
    case Kind::cauchy:
        return referenceOf(bm::cauchy(), p[0], p[1]);
    case Kind::rayleigh:
        return referenceOf(bm::rayleigh(), p[0], p[1]);
    case Kind::logNormal:
        return referenceOf(bm::lognormal(std::log(p[0]), p[1]), 0.0, 1.0);
    case Kind::stable:
        return symmetricStable(p[2], p[0], p[1]);
    case Kind::gamma:
        return referenceOf(bm::gamma_distribution<>(p[2], 1.0), p[0], p[1]);
    case Kind::chiSquared:
        return referenceOf(bm::chi_squared(p[2]), p[0], p[1]);
    case Kind::fisherF:
        return referenceOf(bm::fisher_f(p[2], p[3]), p[0], p[1]);
    case Kind::studentT:
        return referenceOf(bm::students_t(p[2]), p[0], p[1]);
    case Kind::beta:
        return referenceOf(bm::beta_distribution<>(p[2], p[3]), p[0], p[1]);
    case Kind::pareto:
        return referenceOf(bm::pareto(p[0], p[1]), 0.0, 1.0);
    case Kind::triangular:
        return referenceOf(bm::triangular(0.0, p[2], 1.0), p[0], p[1]);
    case Kind::trapezoidal:
        return trapezoid(p[2], p[0], p[1]);
    case Kind::poisson:
        break;
    }
    throw LogicError("a Poisson distribution has no continuous reference");
}

struct Row {
    const char* name;
    Kind kind;
    double min, max;
    std::vector<double> parameters = {}; ///< none: those that follow from min and max
};
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

Distribution made(const Row& row) {
    return row.parameters.empty() ? Distribution(row.kind, row.min, row.max)
                                  : Distribution(row.kind, row.min, row.max, row.parameters);
}

std::vector<double> draws(const Distribution& distribution, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = distribution.at(unitOf(2026, {0, 0, static_cast<int>(distribution.kind())}, i));
    }
    return values;
}

/// sqrt(n) times the Kolmogorov-Smirnov distance to a truncated reference; above 1.95 in one of
/// 1000 samples. `stride` looks at a part of the places alone.
double distance(std::vector<double> values, const Reference& reference, double min, double max,
                std::size_t stride) {
    std::ranges::sort(values);
    const bool inUpperTail = reference.upper(min) < 0.5;
    const double low = reference.lower(min), high = reference.upper(min);
    const double mass = inUpperTail ? high - reference.upper(max) : reference.lower(max) - low;
    const double count = static_cast<double>(values.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < values.size(); i += stride) {
        const double expected = inUpperTail ? (high - reference.upper(values[i])) / mass
                                            : (reference.lower(values[i]) - low) / mass;
        worst = std::max({worst, std::abs(expected - static_cast<double>(i) / count),
                          std::abs(expected - (static_cast<double>(i) + 1.0) / count)});
    }
    return worst * std::sqrt(count);
}

const std::vector<Row> continuous{
    {"uniform", Kind::uniform, 0.9, 1.1},
    {"normal", Kind::normal, 0.99, 1.01},
    {"exponential", Kind::exponential, 1.0, 1.3},
    {"Laplace", Kind::laplace, 0.9, 1.1},
    {"Cauchy", Kind::cauchy, 0.9, 1.1},
    {"Rayleigh", Kind::rayleigh, 1.0, 1.2},
    {"logNormal", Kind::logNormal, 0.95, 1.08},
    {"stable", Kind::stable, 0.9, 1.1},
    {"gamma", Kind::gamma, 1.0, 1.4},
    {"chiSquared", Kind::chiSquared, 1.0, 1.4},
    {"F", Kind::fisherF, 1.0, 1.4},
    {"studentT", Kind::studentT, 0.9, 1.1},
    {"beta", Kind::beta, 0.8, 1.1},
    {"Pareto", Kind::pareto, 1.0, 1.5},
    {"triangular", Kind::triangular, 0.9, 1.2},
    {"trapezoidal", Kind::trapezoidal, 0.9, 1.2},
    // Parameters of one's own, ends far from the middle, and shapes that are singular at an end.
    {"normalFarInItsTail", Kind::normal, 1.3, 1.4, {1.0, 0.01}},
    {"normalFarInItsLowerTail", Kind::normal, 0.65, 0.7, {1.0, 0.01}},
    {"normalThatIsNearlyWhole", Kind::normal, -50.0, 50.0, {1.0, 1.0}},
    {"exponentialFarOut", Kind::exponential, 600.0, 700.0, {0.0, 1.0}},
    {"LaplaceOnItsLeft", Kind::laplace, -30.0, -20.0, {0.0, 1.0}},
    {"CauchyFarOut", Kind::cauchy, 1e6, 1e9, {0.0, 1.0}},
    {"logNormalWide", Kind::logNormal, 1e-3, 1e3, {1.0, 2.0}},
    {"gammaOfASmallShape", Kind::gamma, 0.0, 1.0, {0.0, 1.0, 0.1}},
    {"gammaOfALargeShape", Kind::gamma, 900.0, 1200.0, {0.0, 1.0, 1000.0}},
    {"gammaFarOut", Kind::gamma, 300.0, 400.0, {0.0, 1.0, 5.0}},
    {"chiSquaredOfOne", Kind::chiSquared, 0.0, 10.0, {0.0, 1.0, 1.0}},
    {"FWithHeavyTail", Kind::fisherF, 10.0, 1e6, {0.0, 1.0, 1.0, 1.0}},
    {"studentTFarOut", Kind::studentT, 100.0, 1e4, {0.0, 1.0, 3.0}},
    {"betaInItsCorner", Kind::beta, 0.99, 1.0, {0.0, 1.0, 0.5, 0.5}},
    {"triangularCutBesideItsMode", Kind::triangular, 1.0, 2.9, {0.0, 3.0, 0.3}},
    {"triangularThatFalls", Kind::triangular, 0.0, 2.5, {0.0, 3.0, 0.0}},
    {"triangularThatRises", Kind::triangular, -1.0, 2.0, {-1.0, 3.0, 1.0}},
    {"trapezoidalCutOnOneSide", Kind::trapezoidal, 0.2, 2.5, {0.0, 3.0, 0.7}},
    {"trapezoidalThatIsATent", Kind::trapezoidal, -1.0, 2.0, {-1.0, 3.0, 0.0}},
    {"trapezoidalThatIsLevel", Kind::trapezoidal, -0.5, 1.0, {-1.0, 3.0, 1.0}},
    {"ParetoFarOut", Kind::pareto, 1e3, 1e5, {1.0, 2.5}},
};

} // namespace

class ContinuousDistribution : public testing::TestWithParam<Row> {};

TEST_P(ContinuousDistribution, PassesKolmogorovAndSmirnovAgainstBoostAtAHundredThousandDraws) {
    const Row& row = GetParam();
    const Distribution distribution = made(row);
    const std::vector<double> values = draws(distribution, 100000);
    EXPECT_GE(std::ranges::min(values), row.min);
    EXPECT_LE(std::ranges::max(values), row.max);
    const Reference reference = referenceOf(row.kind, distribution.parameters(), row.min, row.max);
    // The inversion of a characteristic function is slow: 500 places of it will do.
    const double found =
        distance(values, reference, row.min, row.max, row.kind == Kind::stable ? 199 : 1);
    EXPECT_LT(found, 1.95);
    RecordProperty("sqrt_n_times_distance", std::to_string(found));
}

TEST_P(ContinuousDistribution, IsTheInverseOfItsOwnProbability) {
    const Distribution distribution = made(GetParam());
    double last = distribution.minimum();
    for (const double u : {1e-15, 1e-9, 1e-4, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0 - 1e-4, 1.0 - 1e-9}) {
        const double x = distribution.at(u);
        EXPECT_GE(x, last) << u;
        last = x;
        // A step of one unit in the last place of x may be more than 1e-12 of the probability.
        const double slack = std::abs(distribution.probabilityUpTo(std::nextafter(x, 1e300)) -
                                      distribution.probabilityUpTo(std::nextafter(x, -1e300)));
        EXPECT_NEAR(distribution.probabilityUpTo(x), u, 1e-12 + 16.0 * slack) << u;
    }
    EXPECT_EQ(distribution.probabilityUpTo(distribution.maximum()), 1.0);
    EXPECT_EQ(distribution.probabilityUpTo(distribution.minimum() - 1.0), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, ContinuousDistribution, testing::ValuesIn(continuous),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(LevyDistribution, PassesKolmogorovAndSmirnovAgainstItsClosedForm) {
    const Distribution levy(Kind::stable, 0.0, 50.0, {0.0, 1.0, 0.5, 1.0});
    const Reference reference{[](double x) { return std::erfc(std::sqrt(0.5 / x)); },
                              [](double x) { return std::erf(std::sqrt(0.5 / x)); }};
    EXPECT_LT(distance(draws(levy, 20000), reference, 1e-300, 50.0, 1), 1.95);
}

TEST(PoissonDistribution, PassesChiSquaredAgainstBoostAtAHundredThousandDraws) {
    const std::array<Row, 4> rows{{{"default", Kind::poisson, 0.0, 12.0},
                                   {"noninteger ends", Kind::poisson, 2.5, 9.9, {4.0}},
                                   {"far tail", Kind::poisson, 60.0, 90.0, {5.0}},
                                   {"large mean", Kind::poisson, 950.0, 1050.0, {1000.0}}}};
    for (const Row& row : rows) {
        const Distribution distribution = made(row);
        const boost::math::poisson law(distribution.parameters().front());
        std::map<int, double> counts;
        for (const double value : draws(distribution, 100000)) {
            EXPECT_EQ(value, std::floor(value)) << row.name;
            EXPECT_GE(value, row.min) << row.name;
            EXPECT_LE(value, row.max) << row.name;
            ++counts[static_cast<int>(value)];
        }
        double mass = 0.0;
        for (int k = static_cast<int>(std::ceil(row.min)); k <= row.max; ++k) {
            mass += pdf(law, k);
        }
        // Rare numbers share a class.
        double statistic = 0.0, expected = 0.0, found = 0.0;
        int classes = -1;
        for (int k = static_cast<int>(std::ceil(row.min)); k <= row.max; ++k) {
            expected += 1e5 * pdf(law, k) / mass;
            found += counts[k];
            if (expected < 10.0 && k + 1 <= row.max) {
                continue;
            }
            statistic +=
                expected > 0.0 ? (found - expected) * (found - expected) / expected : found;
            ++classes;
            expected = found = 0.0;
        }
        EXPECT_LT(statistic, quantile(boost::math::chi_squared(std::max(classes, 1)), 0.999))
            << row.name;
    }
}

TEST(Distribution, IsFixedWhereItsEndsAreEqual) {
    for (int k = 0; k < distributionKindCount; ++k) {
        const Distribution fixed(static_cast<Kind>(k), 1.0, 1.0);
        EXPECT_TRUE(fixed.isFixed());
        EXPECT_EQ(fixed.at(0.3), 1.0);
        EXPECT_EQ(Distribution(static_cast<Kind>(k), -0.7, -0.7).at(0.9), -0.7) << k;
    }
    EXPECT_EQ(Distribution().at(0.1), 1.0);
}

TEST(Distribution, GivesTheSameBitsEverywhere) {
    // Made with g++ 12 -O0 and equal with -O3 -march=native and with clang++ 14.
    const std::array<std::array<std::uint64_t, 3>, distributionKindCount> golden{{
#include "tests/signature/DistributionGolden.inc"
    }};
    for (int k = 0; k < distributionKindCount; ++k) {
        const Kind kind = static_cast<Kind>(k);
        const Distribution distribution =
            kind == Kind::poisson ? Distribution(kind, 0.0, 20.0) : Distribution(kind, 0.9, 1.3);
        for (std::uint64_t i = 0; i < 3; ++i) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>(distribution.at(unitOf(1, {0, 0, k}, i))),
                      golden[static_cast<std::size_t>(k)][i])
                << info(kind).name << ", draw " << i;
        }
    }
}

TEST(Distribution, GivesTheSameSequencesEverywhere) {
    // Digests (FNV-1a) of ten thousand draws of each, a thousand of the stable law, made as above.
    constexpr std::array<std::uint64_t, distributionKindCount> golden{
        0x67faaa0095d05d8e, 0xbd954490cfafbc3f, 0x1782278b75ae2741, 0x1ee17537a8a248ee,
        0x6e7e07ac3d4aa883, 0xef43840adf9ae6b7, 0xd05a9b5bc46ffff6, 0x004b4f5b1e13b253,
        0x7e4d0f139a22c0ba, 0xbbc7044d7e1f6a43, 0x2199a085c0357f14, 0x2e8b55db4d8172f3,
        0x360587f85c71ca57, 0x1993acd6f8a48669, 0xe5274d476b3cf1d9, 0xcb261191f32b492c,
        0xd5653dd77f567488};
    for (int k = 0; k < distributionKindCount; ++k) {
        const Kind kind = static_cast<Kind>(k);
        const Distribution distribution =
            kind == Kind::poisson ? Distribution(kind, 0.0, 20.0) : Distribution(kind, 0.9, 1.3);
        std::uint64_t digest = 14695981039346656037ULL;
        const std::uint64_t draws = kind == Kind::stable ? 1000 : 10000;
        for (std::uint64_t i = 0; i < draws; ++i) {
            const auto bits =
                std::bit_cast<std::uint64_t>(distribution.at(unitOf(1, {0, 0, k}, i)));
            for (int byte = 0; byte < 8; ++byte) {
                digest ^= bits >> (8 * byte) & 0xff;
                digest *= 1099511628211ULL;
            }
        }
        EXPECT_EQ(digest, golden[static_cast<std::size_t>(k)]) << info(kind).name;
    }
}

TEST(Distribution, RefusesNumbersThatCannotBe) {
    const double nan = std::nan("");
    const struct {
        const char* name;
        Kind kind;
        double min, max;
        std::vector<double> parameters;
        const char* says;
    } rows[] = {
        {"reversed ends", Kind::uniform, 1.1, 0.9, {}, "min 1.1, expected at most max, 0.9"},
        {"a min that is no number", Kind::uniform, nan, 1.0, {}, "min nan"},
        {"an infinite max", Kind::normal, 0.0, 1.0 / 0.0, {}, "max inf"},
        {"no such distribution",
         static_cast<Kind>(distributionKindCount),
         0.9,
         1.1,
         {},
         "a number from 0 to 1"},
        {"log-normal through 0", Kind::logNormal, 0.0, 1.0, {}, "more than 0"},
        {"Pareto from below 0", Kind::pareto, -1.0, 1.0, {}, "more than 0"},
        {"Poisson around 0", Kind::poisson, -1.0, 1.0, {}, "a mean of 0"},
        {"Poisson between whole numbers", Kind::poisson, 0.9, 0.99, {}, "no whole number"},
        {"Poisson below 0", Kind::poisson, -3.0, -1.0, {2.0}, "no whole number"},
        {"a mode outside",
         Kind::triangular,
         0.9,
         1.1,
         {0.9, 0.2, 1.5},
         "mode 1.5, expected a part"},
        {"a top wider than its foot",
         Kind::trapezoidal,
         0.9,
         1.1,
         {0.9, 0.2, 1.5},
         "top 1.5, expected a part"},
        {"no standard deviation", Kind::normal, 0.9, 1.1, {1.0, 0.0}, "standard deviation 0"},
        {"too few parameters", Kind::gamma, 0.9, 1.1, {1.0, 1.0}, "expected 3"},
        {"a parameter that is no number", Kind::normal, 0.9, 1.1, {nan, 1.0}, "mean nan"},
        {"exponential behind its end", Kind::exponential, 0.0, 1.0, {2.0, 1.0}, "no probability"},
        {"beta beside its range", Kind::beta, 2.0, 3.0, {0.0, 1.0, 2.0, 2.0}, "no probability"},
        {"stable near 1", Kind::stable, 0.9, 1.1, {1.0, 0.1, 1.05, 0.0}, "alpha 1.05"},
        {"skewed Cauchy", Kind::stable, 0.9, 1.1, {1.0, 0.1, 1.0, 0.5}, "0 where alpha is 1"},
        {"a shape of 0", Kind::fisherF, 0.9, 1.1, {0.0, 1.0, 0.0, 1.0}, "degrees of freedom 1"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(smat::test::refusalOf([&] {
                        if (row.parameters.empty()) {
                            Distribution(row.kind, row.min, row.max);
                        } else {
                            Distribution(row.kind, row.min, row.max, row.parameters);
                        }
                    }),
                    HasSubstr(row.says))
            << row.name;
    }
}

TEST(Distribution, ComparesByItsNumbers) {
    EXPECT_EQ(Distribution(Kind::normal, 0.9, 1.1), Distribution(Kind::normal, 0.9, 1.1));
    EXPECT_NE(Distribution(Kind::normal, 0.9, 1.1), Distribution(Kind::normal, 0.9, 1.2));
    EXPECT_TRUE(Distribution(Kind::normal, 0.9, 1.1).hasDefaultParameters());
    EXPECT_FALSE(Distribution(Kind::normal, 0.9, 1.1, {1.0, 0.01}).hasDefaultParameters());
}

} // namespace irsg
