#include "irsg/scattering/SizeDistribution.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

double moment(const SizeDistribution& sizes, double order) {
    const SizeDistribution::Nodes nodes = sizes.nodes();
    double sum = 0.0;
    for (std::size_t i = 0; i < nodes.radii_um.size(); ++i) {
        sum += nodes.numbers[i] * std::pow(nodes.radii_um[i], order);
    }
    return sum;
}

TEST(SizeDistribution, HasTheMomentsOfTheGammaDistribution) {
    // <r^p> / <r^q> = (mode / width)^(p - q) Gamma(width + 1 + p) / Gamma(width + 1 + q).
    for (const SizeDistribution& sizes :
         {SizeDistribution::advectionFog(), SizeDistribution::radiationFog()}) {
        for (const double p : {3.0, 4.0}) {
            const double expected = std::pow(sizes.radius_um / sizes.width, p - 2.0) *
                                    std::tgamma(sizes.width + 1.0 + p) /
                                    std::tgamma(sizes.width + 3.0);
            EXPECT_NEAR(moment(sizes, p) / moment(sizes, 2.0) / expected, 1.0, 1e-6);
        }
    }
}

TEST(SizeDistribution, HasTheMomentsOfTheLogNormalDistribution) {
    const SizeDistribution sizes{SizeDistribution::Kind::logNormal, 5.0, 1.6};
    const double s2 = std::pow(std::log(1.6), 2);
    EXPECT_NEAR(moment(sizes, 3.0) / moment(sizes, 2.0) / (5.0 * std::exp(2.5 * s2)), 1.0, 1e-6);
}

TEST(SizeDistribution, OfOneRadiusIsThatRadius) {
    EXPECT_EQ(SizeDistribution::single(50.0).nodes().radii_um.size(), 1u);
    EXPECT_NEAR(SizeDistribution::single(50.0).meanDiameter_um(), 100.0, 1e-12);
}

TEST(SizeDistribution, RefusesImpossibleParameters) {
    using Kind = SizeDistribution::Kind;
    for (const SizeDistribution& sizes :
         {SizeDistribution{Kind::single, 0.0, 1.0}, SizeDistribution{Kind::single, -5.0, 1.0},
          SizeDistribution{Kind::gamma, 5.0, 0.0}, SizeDistribution{Kind::logNormal, 5.0, 1.0},
          SizeDistribution{Kind::logNormal, std::nan(""), 2.0}}) {
        EXPECT_THROW(sizes.nodes(), InputError);
    }
}

} // namespace
} // namespace irsg
