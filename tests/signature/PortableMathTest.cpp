#include "irsg/signature/random/PortableMath.h"

#include <cmath>
#include <limits>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <gtest/gtest.h>

#include "irsg/signature/random/LogTails.h"
#include "irsg/signature/random/Philox.h"
#include "irsg/signature/random/StableDistribution.h"

namespace irsg {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double relative(double found, double expected) {
    return std::abs(found - expected) / std::max(std::abs(expected), 1e-300);
}

} // namespace

TEST(PortableMath, AgreesWithTheLibraryOfThisMachine) {
    double worst = 0.0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double u = unitOf(5, {9, 0, 0}, i);
        const double x = 1400.0 * (u - 0.5), small = (u - 0.5) * std::exp(-40.0 * u);
        worst = std::max({worst, relative(portable::exp(x), std::exp(x)),
                          relative(portable::log(std::exp(x)), std::log(std::exp(x))),
                          relative(portable::log1p(small), std::log1p(small)),
                          relative(portable::expm1(small), std::expm1(small)),
                          relative(portable::atan(x), std::atan(x)),
                          relative(portable::atan(small), std::atan(small)),
                          std::abs(portable::sin(x) - std::sin(x)),
                          std::abs(portable::cos(x) - std::cos(x))});
        const double gamma = std::lgamma(60.0 * u);
        EXPECT_NEAR(portable::logGamma(60.0 * u), gamma, 3e-14 * (1.0 + std::abs(gamma)));
    }
    EXPECT_LT(worst, 2e-15);
}

TEST(PortableMath, KnowsTheEndsOfItsFunctions) {
    EXPECT_EQ(portable::exp(-infinity), 0.0);
    EXPECT_EQ(portable::exp(infinity), infinity);
    EXPECT_EQ(portable::exp(-744.0), std::exp(-744.0));
    EXPECT_EQ(portable::log(0.0), -infinity);
    EXPECT_TRUE(std::isnan(portable::log(-1.0)));
    EXPECT_EQ(portable::log(5e-324), std::log(5e-324));
    EXPECT_EQ(portable::log1p(1e-300), 1e-300);
    EXPECT_EQ(portable::log1mExp(-infinity), 0.0);
    EXPECT_NEAR(portable::log1mExp(-1e-20), std::log(1e-20), 1e-13);
    EXPECT_EQ(portable::log1mExp(0.0), -infinity);
}

TEST(LogTails, AgreeWithBoostInBothTails) {
    for (const double a : {0.05, 0.5, 2.0, 30.0, 3000.0}) {
        for (const double x :
             {1e-6 * a, 0.3 * a, 0.9 * a, a, 1.2 * a, a + 8.0 * std::sqrt(a) + 5.0}) {
            const LogTails tails = gammaTails(a, x);
            EXPECT_LT(relative(std::exp(tails.lower), boost::math::gamma_p(a, x)), 1e-10)
                << a << " " << x;
            EXPECT_LT(relative(std::exp(tails.upper), boost::math::gamma_q(a, x)), 1e-10)
                << a << " " << x;
        }
    }
    for (const double a : {0.05, 0.7, 5.0, 400.0}) {
        for (const double b : {0.05, 2.0, 70.0}) {
            for (const double x : {1e-9, 0.1, 0.5, 0.93, 1.0 - 1e-9}) {
                const LogTails tails = betaTails(a, b, x, 1.0 - x);
                const double lower = boost::math::ibeta(a, b, x);
                const double upper = boost::math::ibetac(a, b, x);
                if (lower > 1e-290) {
                    EXPECT_LT(relative(std::exp(tails.lower), lower), 1e-10)
                        << a << " " << b << " " << x;
                }
                if (upper > 1e-290) {
                    EXPECT_LT(relative(std::exp(tails.upper), upper), 1e-10)
                        << a << " " << b << " " << x;
                }
            }
        }
    }
    const boost::math::normal normal;
    for (const double z : {-37.0, -5.0, -1e-3, 0.0, 0.7, 8.0, 37.0}) {
        EXPECT_LT(relative(std::exp(normalTails(z).lower), cdf(normal, z)), 2e-13) << z;
        EXPECT_LT(relative(std::exp(normalTails(z).upper), cdf(complement(normal, z))), 2e-13) << z;
    }
}

TEST(LogTails, GoOnWhereTheProbabilityIsZeroInDoublePrecision) {
    // ln Q(z) = -z^2 / 2 - ln(z sqrt(2 pi)) + ln(1 - 1 / z^2 + 3 / z^4 - ...).
    for (const double z : {50.0, 1e3, 1e6}) {
        const double z2 = z * z;
        const double expected = -0.5 * z2 - std::log(z * std::sqrt(2.0 * 3.14159265358979324)) +
                                std::log1p((-1.0 + (3.0 + (-15.0 + 105.0 / z2) / z2) / z2) / z2);
        EXPECT_LT(relative(normalTails(z).upper, expected), 1e-14) << z;
    }
}

TEST(StableDistribution, IsLevysOwnTheNormalAndTheCauchyDistributionInItsSpecialCases) {
    const StableDistribution levy(0.5, 1.0), mirrored(0.5, -1.0), gauss(2.0, 0.0), cauchy(1.0, 0.0);
    const boost::math::normal normal(0.0, std::sqrt(2.0));
    for (const double z : {0.003, 0.05, 0.4, 1.0, 7.0, 1e4, 1e12}) {
        // F(z) = erfc(sqrt(1 / (2 z))).
        const double root = std::sqrt(0.5 / z);
        EXPECT_LT(relative(std::exp(levy.tails(z).lower), std::erfc(root)), 1e-10) << z;
        EXPECT_LT(relative(std::exp(levy.tails(z).upper), std::erf(root)), 1e-10) << z;
        EXPECT_LT(relative(std::exp(mirrored.tails(-z).upper), std::erfc(root)), 1e-10) << z;
        if (z < 30.0) {
            EXPECT_LT(relative(std::exp(gauss.tails(z).upper), cdf(complement(normal, z))), 1e-10)
                << z;
            EXPECT_LT(relative(std::exp(gauss.tails(-z).lower), cdf(normal, -z)), 1e-10) << z;
        }
        EXPECT_LT(
            relative(std::exp(cauchy.tails(z).upper), std::atan(1.0 / z) / 3.14159265358979324),
            1e-13)
            << z;
    }
    EXPECT_EQ(levy.tails(-1.0).lower, -infinity);
}

} // namespace irsg
