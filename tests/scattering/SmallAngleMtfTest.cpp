#include "irsg/scattering/SmallAngleMtf.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/WaterIndex.h"
#include "tests/scattering/NarrowPhase.h"

namespace irsg {
namespace {

using test::narrow;

TEST(PhaseFunction, SumsToOneAndHasItsAsymmetry) {
    // Henyey-Greenstein: the mean cosine is g.
    std::vector<double> angles, values;
    const double g = 0.8;
    for (int i = 0; i <= 20000; ++i) {
        angles.push_back(pi * i / 20000.0);
        values.push_back(std::pow(1.0 + g * g - 2.0 * g * std::cos(angles.back()), -1.5));
    }
    const PhaseFunction phase(angles, values);
    EXPECT_NEAR(phase.asymmetry(), g, 1e-6);
    const double forward = (1.0 - g * g) / (2.0 * g) * (1.0 / (1.0 - g) - 1.0 / std::hypot(1.0, g));
    EXPECT_NEAR(phase.forwardFraction(), forward, 1e-6);
    // Its cosine at a share, from the inverse of its sum.
    for (const double u : {0.1, 0.5, 0.9}) {
        const double s = (1.0 - g * g) / (1.0 + g - 2.0 * g * u);
        EXPECT_NEAR(phase.cosineAt(u), (1.0 + g * g - s * s) / (2.0 * g), 1e-5);
    }
}

TEST(PhaseFunction, HasTheTransformOfANarrowExponential) {
    // For small angles exp(-t / w) / (2 pi w^2) has the transform (1 + (2 pi k w)^2)^(-3/2).
    const double w = 0.01;
    const PhaseFunction phase = narrow(w);
    EXPECT_NEAR(phase.transform(0.0), 1.0, 1e-6);
    for (const double k : {1e-4, 1.0, 5.0, 16.0, 50.0, 200.0}) {
        EXPECT_NEAR(phase.transform(k), std::pow(1.0 + std::pow(2.0 * pi * k * w, 2), -1.5), 3e-4)
            << k;
    }
}

TEST(PhaseFunction, OfMieTheoryHasTheAsymmetryOfItsSeries) {
    const DropletOptics optics =
        dropletOptics(SizeDistribution::single(50.0), waterIndex(4.0), 4.0);
    EXPECT_NEAR(optics.phase.asymmetry(), 0.9, 0.1);
    EXPECT_GT(optics.albedo(), 0.5);
    EXPECT_LT(optics.albedo(), 0.75);
}

TEST(SmallAngleMtf, HasItsEnds) {
    const SmallAngleMtf theory(narrow(0.01), {{}}, 1e4);
    const MtfCurve curve = theory.curve(2.0, mtfFrequencies(0.05, 1e4, 101));
    EXPECT_NEAR(curve.gain(), std::exp(2.0), 1e-5);
    EXPECT_NEAR(curve.direct(), 1.0, 0.01);
    EXPECT_TRUE(std::ranges::is_sorted(curve.values(), std::greater<>()));
}

TEST(SmallAngleMtf, HasTheClosedFormOfAUniformPath) {
    // Int_0^1 (1 + (a s)^2)^(-3/2) ds = 1 / sqrt(1 + a^2).
    const double w = 0.01;
    const SmallAngleMtf theory(narrow(w), {{}}, 1e4);
    for (const double k : {0.3, 3.0, 30.0, 300.0}) {
        const double a = 2.0 * pi * k * w;
        EXPECT_NEAR(theory.meanTransform(k), 1.0 / std::sqrt(1.0 + a * a), 3e-4) << k;
    }
}

TEST(SmallAngleMtf, OfEqualLayersIsThatOfOne) {
    const SmallAngleMtf one(narrow(0.01), {{}}, 1e3);
    const SmallAngleMtf three(narrow(0.01), {{1.0, 7.0}, {2.0, 7.0}, {5.0, 7.0}}, 1e3);
    for (const double k : {0.0, 1.0, 10.0, 100.0}) {
        EXPECT_NEAR(one.meanTransform(k), three.meanTransform(k), 1e-12);
    }
}

TEST(SmallAngleMtf, BlursMoreWhereTheDropletsAreAtTheSensor) {
    // A shower curtain: before the eye it hides, before the object it does not.
    const PhaseFunction phase = narrow(0.01);
    const SmallAngleMtf atSensor(phase, {{0.1, 1.0}, {0.9, 0.0}}, 1e3);
    const SmallAngleMtf atTarget(phase, {{0.9, 0.0}, {0.1, 1.0}}, 1e3);
    EXPECT_LT(atSensor.meanTransform(20.0), atTarget.meanTransform(20.0));
    EXPECT_NEAR(atSensor.meanTransform(0.0), atTarget.meanTransform(0.0), 1e-12);
    // All of a thin layer at the sensor displaces by the whole angle.
    const SmallAngleMtf thin(phase, {{1e-4, 1.0}, {1.0, 0.0}}, 1e3);
    EXPECT_NEAR(thin.meanTransform(10.0), phase.transform(10.0), 1e-3);
}

TEST(SmallAngleMtf, RefusesLayersThatDoNotScatter) {
    EXPECT_THROW(normalised({{1.0, 0.0}}), InputError);
    EXPECT_THROW(normalised({}), InputError);
    EXPECT_THROW(normalised({{0.0, 1.0}}), InputError);
    EXPECT_THROW(normalised({{1.0, -1.0}}), InputError);
    EXPECT_THROW(mtfFrequencies(1.0, 0.5, 10), InputError);
}

} // namespace
} // namespace irsg
