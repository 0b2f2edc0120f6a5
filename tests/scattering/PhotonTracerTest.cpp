#include "irsg/scattering/PhotonTracer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "tests/scattering/NarrowPhase.h"

namespace irsg {
namespace {

using test::narrow;

TEST(PhotonTracer, AgreesWithTheSmallAngleTheoryWhereAnglesAreSmall) {
    const PhaseFunction phase = narrow(0.003);
    const std::vector<double> frequencies{0.0, 1.0, 10.0, 30.0, 100.0};
    for (const std::vector<ScatteringLayer>& layers :
         {std::vector<ScatteringLayer>{{}}, {{0.3, 5.0}, {0.3, 0.0}, {0.4, 1.0}}}) {
        const SmallAngleMtf theory(phase, layers, 200.0);
        for (const double depth : {0.5, 3.0}) {
            const PhotonTracer tracer(phase, layers, depth, frequencies);
            const PhotonEstimate traced = tracer.estimate(tracer.trace(7, 0, 40000));
            const MtfCurve expected = theory.curve(depth, frequencies);
            for (std::size_t i = 0; i < frequencies.size(); ++i) {
                EXPECT_NEAR(traced.mtf[i], expected.values()[i],
                            4.0 * traced.standardError[i] + 2e-3 * expected.values()[i])
                    << depth << ", " << frequencies[i];
            }
        }
    }
}

TEST(PhotonTracer, LosesNothingWhereAllGoesForward) {
    const PhotonTracer tracer(narrow(1e-3), {{}}, 4.0, {0.0});
    EXPECT_NEAR(tracer.estimate(tracer.trace(1, 0, 1000)).mtf[0], std::exp(4.0), 1e-9);
}

/// Part of normally incident light that passes a slab of isotropic scatterers: Milne's integral
/// equation for the number of collisions at a depth, N(t) = e^-t + 1/2 Int N(t') E1|t - t'| dt',
/// order by order, with the mean of the kernel over cells.
double passedSlab(double depth) {
    constexpr int cells = 300;
    const double h = depth / cells;
    const auto e1 = [](double x) { return -std::expint(-x); };
    const auto e2 = [&](double x) { return x > 0.0 ? std::exp(-x) - x * e1(x) : 1.0; };
    std::vector<double> order, all(cells, 0.0);
    for (int i = 0; i < cells; ++i) {
        order.push_back(std::exp(-h * i) - std::exp(-h * (i + 1)));
    }
    // From the middle of a cell into another one; into its own both ways.
    std::vector<double> reach{1.0 - e2(0.5 * h)};
    for (int k = 1; k < cells; ++k) {
        reach.push_back(0.5 * (e2(h * (k - 0.5)) - e2(h * (k + 0.5))));
    }
    for (int n = 0; n < 200; ++n) {
        std::vector<double> next(cells, 0.0);
        for (std::size_t i = 0; i < cells; ++i) {
            all[i] += order[i];
            for (std::size_t j = 0; j < cells; ++j) {
                next[j] += order[i] * reach[i > j ? i - j : j - i];
            }
        }
        order = next;
    }
    double passed = std::exp(-depth);
    for (int i = 0; i < cells; ++i) {
        passed += 0.5 * all[static_cast<std::size_t>(i)] * e2(h * (cells - i - 0.5));
    }
    return passed;
}

TEST(PhotonTracer, LetsThroughWhatMilnesEquationLetsThrough) {
    std::vector<double> angles, values;
    for (int i = 0; i <= 1000; ++i) {
        angles.push_back(pi * i / 1000.0);
        values.push_back(1.0);
    }
    const PhaseFunction isotropic(angles, values);
    for (const double depth : {0.5, 1.0, 4.0}) {
        const PhotonTracer tracer(isotropic, {{}}, depth, {0.0});
        const PhotonEstimate all = tracer.estimate(tracer.trace(3, 0, 200000));
        EXPECT_NEAR(std::exp(-depth) * all.mtf[0], passedSlab(depth),
                    4.0 * std::exp(-depth) * all.standardError[0] + 5e-4);
    }
}

TEST(PhotonTracer, StatesAnErrorThatHolds) {
    // Standard errors against the spread of 40 batches.
    const PhaseFunction phase = narrow(0.05);
    const PhotonTracer tracer(phase, {{}}, 2.0, {3.0});
    double sum = 0.0, squares = 0.0, stated = 0.0;
    for (std::uint64_t batch = 0; batch < 40; ++batch) {
        const PhotonEstimate one = tracer.estimate(tracer.trace(5, batch, 2000));
        sum += one.mtf[0];
        squares += one.mtf[0] * one.mtf[0];
        stated += one.standardError[0] / 40.0;
    }
    const double spread = std::sqrt((squares - sum * sum / 40.0) / 39.0);
    EXPECT_NEAR(stated / spread, 1.0, 0.35);
}

TEST(PhotonTracer, RepeatsItselfForASeed) {
    const PhaseFunction phase = narrow(0.05);
    const PhotonTracer tracer(phase, {{}}, 2.0, {0.0, 3.0});
    EXPECT_EQ(tracer.trace(5, 2, 500).sums, tracer.trace(5, 2, 500).sums);
    EXPECT_NE(tracer.trace(5, 2, 500).sums, tracer.trace(5, 3, 500).sums);
    EXPECT_NE(tracer.trace(5, 2, 500).sums, tracer.trace(6, 2, 500).sums);
}

} // namespace
} // namespace irsg
