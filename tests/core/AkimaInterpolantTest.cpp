// The curve that is drawn between the cases of adaptive sweeps, against curves in closed form.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/data/AkimaInterpolant.h"

namespace smat {
namespace {

template <typename F>
std::vector<double> of(const std::vector<double>& x, F&& f) {
    std::vector<double> y;
    for (const double one : x) {
        y.push_back(f(one));
    }
    return y;
}

TEST(AkimaInterpolant, IsAParabolaWhereItsSamplesAreHoweverTheyAreSpaced) {
    const std::vector<double> x{-2.0, -1.5, 0.1, 0.2, 1.0, 3.0, 3.5};
    const auto parabola = [](double at) { return 3.0 - 2.0 * at + 0.7 * at * at; };
    const AkimaInterpolant curve(x, of(x, parabola));
    for (double at = -2.0; at <= 3.5; at += 0.01) {
        EXPECT_NEAR(curve.at(at), parabola(at), 1e-12) << at;
    }
    EXPECT_EQ(curve.at(3.5), parabola(3.5));
    EXPECT_TRUE(std::isnan(curve.at(-2.001)) && std::isnan(curve.at(3.501)));
}

TEST(AkimaInterpolant, IsNearerToAKinkThanAStraightLineMayBe) {
    const auto bent = [](double at) { return std::abs(at - 3.0); };
    const std::vector<double> x{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    const AkimaInterpolant onSample(x, of(x, bent));
    const auto between = [](double at) { return std::abs(at - 3.5); };
    const AkimaInterpolant offSample(x, of(x, between));
    for (double at = 0.0; at <= 6.0; at += 0.01) {
        // Rounded by 2/27 of a step times what the slope changes by.
        EXPECT_NEAR(onSample.at(at), bent(at), 4.0 / 27.0 + 1e-12) << at;
        if (std::abs(at - 3.0) >= 1.0) {
            EXPECT_NEAR(onSample.at(at), bent(at), 1e-12) << at;
        }
    }
    EXPECT_NEAR(offSample.at(3.5), 0.25, 1e-12) << "where a straight line is at 0.5";
}

TEST(AkimaInterpolant, ClosesATurnAndIsThereAnywhereOnIt) {
    std::vector<double> x;
    for (int i = 0; i < 24; ++i) {
        x.push_back(15.0 * i);
    }
    const auto lobe = [](double at) { return 2.0 + std::cos(irsg::radians(at + 20.0)); };
    const AkimaInterpolant curve(x, of(x, lobe), 360.0);
    const double straight = 1.0 - std::cos(irsg::radians(7.5)); // what a chord is off at its middle
    for (double at = -30.0; at < 400.0; at += 0.7) {
        EXPECT_NEAR(curve.at(at), lobe(at), 0.15 * straight) << at;
    }
    EXPECT_EQ(curve.at(352.5), curve.between(23, 0.5));
}

TEST(AkimaInterpolant, DoesNotSwingBesideAJump) {
    const std::vector<double> x{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
    const AkimaInterpolant curve(x, {1.0, 1.0, 1.0, 2.0, 2.0, 2.0});
    for (double at = 0.0; at <= 5.0; at += 0.01) {
        EXPECT_GE(curve.at(at), 1.0 - 1e-12) << at;
        EXPECT_LE(curve.at(at), 2.0 + 1e-12) << at;
    }
}

TEST(AkimaInterpolant, TakesFewSamplesAndRefusesWhatIsNoCurve) {
    EXPECT_EQ(AkimaInterpolant({1.0}, {5.0}).at(1.0), 5.0);
    EXPECT_EQ(AkimaInterpolant({1.0, 2.0}, {5.0, 7.0}).at(1.5), 6.0);
    EXPECT_EQ(AkimaInterpolant({10.0}, {5.0}, 360.0).at(200.0), 5.0);
    EXPECT_NEAR(AkimaInterpolant({0.0, 180.0}, {1.0, 3.0}, 360.0).at(90.0), 2.0, 1e-12);
    const double gap = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(AkimaInterpolant({1.0, 2.0}, {5.0, gap}), irsg::LogicError);
    EXPECT_THROW(AkimaInterpolant({1.0, 1.0}, {5.0, 5.0}), irsg::LogicError);
    EXPECT_THROW(AkimaInterpolant({1.0, 2.0}, {5.0}), irsg::LogicError);
    EXPECT_THROW(AkimaInterpolant({0.0, 360.0}, {5.0, 5.0}, 360.0), irsg::LogicError);
}

} // namespace
} // namespace smat
