#include "irsg/radiometry/CurveSampling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

using namespace irsg;

namespace {

/// The largest error at the middles and tenths of all pieces, relative to the value or the floor.
double worstError(const Spectrum& spectrum, const std::function<double(double)>& curve) {
    double worst = 0.0;
    const double floor = curveFloor * spectrum.maximum();
    const auto& axis = spectrum.wavelengths_um();
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const double x = std::lerp(axis[i], axis[i + 1], t);
            const double scale = std::max(curve(x), floor);
            worst = std::max(worst, std::abs(spectrum.at(x) - curve(x)) / scale);
        }
    }
    return worst;
}

} // namespace

TEST(CurveSampling, FollowsPlanckFunctionsToAMillionth) {
    for (const double temperature_K : {100.0, 288.15, 1000.0, 5772.0}) {
        const Spectrum sampled = sampledPlanck(temperature_K, {0.2, 40.0}, 3.0);
        const double worst = worstError(sampled, [temperature_K](double wavelength_um) {
            return 3.0 * planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
        });
        EXPECT_LT(worst, 1e-6) << temperature_K << " K";
        EXPECT_LT(sampled.size(), 40000u) << temperature_K << " K";
        std::printf("Planck function of %g K over 0.2-40 um: %zu nodes, error %.1e\n",
                    temperature_K, sampled.size(), worst);
    }
}

TEST(CurveSampling, FollowsSteepExponentialsDownToItsFloor) {
    const auto curve = [](double x) { return std::exp(-1000.0 * (x - 3.0)); };
    const double kinks[] = {3.0, 5.0};
    const Spectrum sampled = sampledCurve(curve, kinks);
    EXPECT_LT(worstError(sampled, curve), 1e-6);
    EXPECT_LT(sampled.size(), 40000u);
    EXPECT_EQ(sampled.at(3.0), 1.0);
}

TEST(CurveSampling, KeepsKinksAndAddsNothingToStraightLines) {
    const double kinks[] = {3.0, 4.0, 5.0};
    const Spectrum sampled = sampledCurve([](double x) { return std::abs(x - 4.0) + 1.0; }, kinks);
    EXPECT_EQ(sampled, Spectrum({3.0, 4.0, 5.0}, {2.0, 1.0, 2.0}));
}

TEST(CurveSampling, OfNothingIsNothing) {
    EXPECT_EQ(sampledPlanck(0.0, {3.0, 5.0}).maximum(), 0.0);
    EXPECT_EQ(sampledPlanck(1.0, {0.2, 1.0}).maximum(), 0.0);
}

TEST(CurveSampling, NeedsTwoWavelengths) {
    const double one[] = {3.0};
    EXPECT_THROW((void)sampledCurve([](double) { return 1.0; }, one), LogicError);
}
