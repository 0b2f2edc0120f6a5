#include "irsg/radiometry/SpectralSampling.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quadrature.h"

using namespace irsg;

namespace {

const SpectralRange mwir{3.0, 5.0};

} // namespace

TEST(SpectralPoints, HaveWeightsOfOneAndTheValuesOfASpectrumThere) {
    const SpectralPoints points({3.0, 3.5, 5.0});
    const Spectrum ramp({3.0, 5.0}, {1.0, 5.0});
    EXPECT_EQ(points.sampled(ramp), (std::vector<double>{1.0, 2.0, 5.0}));
    EXPECT_EQ(points.integrate(points.sampled(ramp)), 8.0);
    EXPECT_EQ(points.integrate(points.sampled(ramp), points.sampled(ramp)), 30.0);
    EXPECT_EQ(points.area_um(), 3.0);
    EXPECT_EQ(points.planck(300.0)[1], planckRadiance_W_m2_sr_um(3.5, 300.0));
}

TEST(SpectralPoints, OfOneWavelengthStandForAnIntervalThatHoldsIt) {
    const SpectralPoints one({4.25});
    EXPECT_EQ(one.size(), 1u);
    EXPECT_LT(one.range().min_um, 4.25);
    EXPECT_GT(one.range().max_um, 4.25);
    EXPECT_LT(one.range().width_um(), 1e-8);
    EXPECT_EQ(one.integrate(std::vector<double>{7.0}), 7.0);
}

TEST(SpectralPoints, RefuseWhatIsNoSampling) {
    EXPECT_THROW(SpectralPoints({}), LogicError);
    EXPECT_THROW(SpectralPoints({4.0, 3.0}), LogicError);
    EXPECT_THROW(SpectralPoints({0.0, 3.0}), LogicError);
    EXPECT_THROW(SpectralPoints({3.0, 4.0}, {1.0}, mwir), LogicError);
    EXPECT_THROW(SpectralPoints({3.0, 4.0}, {1.0, 1.0}, {4.0, 4.0}), LogicError);
    const SpectralPoints points({3.0, 4.0});
    EXPECT_THROW((void)points.integrate(std::vector<double>{1.0}), LogicError);
    EXPECT_THROW((void)points.integrate(std::vector<double>(2), std::vector<double>(3)),
                 LogicError);
}

// A gas that is black in half of a bin and clear in the other half: two nodes of one wavelength
// that share its weight let half of the light through however often it passes, where the mean of
// the bin would let a quarter through twice.
TEST(SpectralPoints, MayHaveSeveralWeightedNodesAtOneWavelength) {
    const SpectralPoints bin({4.0, 4.0}, {0.05, 0.05}, {3.95, 4.05});
    const std::vector<double> through{1.0, 0.0};
    EXPECT_DOUBLE_EQ(bin.integrate(through) / bin.area_um(), 0.5);
    EXPECT_DOUBLE_EQ(bin.integrate(through, through) / bin.area_um(), 0.5);
    EXPECT_EQ(bin.sampled(Spectrum({3.0, 5.0}, {3.0, 5.0})), (std::vector<double>{4.0, 4.0}));
}

TEST(SpectralGrid, IsTheAxisOfASpectrumAndIntegratesItExactly) {
    const Spectrum bent({2.0, 3.0, 3.7, 4.1, 6.0}, {0.0, 1.0, 4.0, 2.0, 8.0});
    const SpectralGrid grid(bent, {2.5, 5.0});
    EXPECT_EQ(grid.wavelengths_um(), (std::vector<double>{2.5, 3.0, 3.7, 4.1, 5.0}));
    EXPECT_EQ(grid.sampled(bent), bent.sample(grid.wavelengths_um()));
    const Spectrum* const factors[] = {&bent};
    EXPECT_NEAR(grid.integrate(grid.sampled(bent)), integrateProduct(factors, {2.5, 5.0}), 1e-14);
    EXPECT_NEAR(grid.area_um(), 2.5, 1e-15);
    EXPECT_EQ(grid.range(), (SpectralRange{2.5, 5.0}));
}

TEST(SpectralGrid, OfAConstantHasTheEndsOfTheRange) {
    const SpectralGrid grid(Spectrum::constant(3.0), mwir);
    EXPECT_EQ(grid.wavelengths_um(), (std::vector<double>{3.0, 5.0}));
    EXPECT_DOUBLE_EQ(grid.integrate(grid.sampled(Spectrum::constant(3.0))), 6.0);
}

TEST(SpectralQuadrature, IsASamplingOfItsBand) {
    const Spectrum a({3.0, 4.0, 5.0}, {0.0, 1.0, 0.5});
    const Spectrum* const kinked[] = {&a};
    const SpectralQuadrature quadrature(Band::topHat(3.0, 5.0), kinked);
    const SpectralSampling& sampling = quadrature;
    EXPECT_EQ(sampling.range(), mwir);
    EXPECT_NEAR(sampling.area_um(), 2.0, 1e-14);
    // Integral of the two lines, and of their squares: 1/2 + 3/4, 1/3 + 7/12.
    EXPECT_NEAR(sampling.integrate(sampling.sampled(a)), 1.25, 1e-14);
    EXPECT_NEAR(sampling.integrate(sampling.sampled(a), sampling.sampled(a)), 11.0 / 12.0, 1e-14);
}

// The sum is taken in four partial sums: as many nodes as leave each number over.
TEST(SpectralSampling, AddsUpAnyNumberOfNodes) {
    for (std::size_t count = 1; count <= 9; ++count) {
        std::vector<double> wavelengths_um(count), weights_um(count), values(count);
        std::iota(wavelengths_um.begin(), wavelengths_um.end(), 3.0);
        std::iota(weights_um.begin(), weights_um.end(), 1.0);
        std::iota(values.begin(), values.end(), 10.0);
        const SpectralPoints points(wavelengths_um, weights_um, {2.0, 20.0});
        EXPECT_EQ(points.integrate(values),
                  std::inner_product(values.begin(), values.end(), weights_um.begin(), 0.0));
    }
}
