#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/DiffuseLight.h"
#include "irsg/atmosphere/engine/PathIntegrator.h"
#include "irsg/radiometry/Planck.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

namespace irsg {
namespace {

using namespace syntheticatmosphere;

/// A vertical path inside one layer, upwards.
RaySegment vertical(const AtmosphericColumn& air, double from_m, double to_m) {
    const AtmosphericColumn::Place place = air.placeOf(0.5 * (from_m + to_m));
    return {static_cast<int>(place.layer), std::abs(to_m - from_m), from_m, to_m, place.fraction,
            to_m > from_m ? 1.0 : -1.0};
}

RayPath pathOf(std::vector<RaySegment> segments) {
    RayPath path;
    path.segments = std::move(segments);
    return path;
}

class PathIntegrator : public testing::Test {
  protected:
    AtmosphericColumn air_{profile(290.0, 6.0), {}, table()};

    NodeColumn column(std::uint32_t node) const {
        return NodeColumn(air_, {node}, {wavenumbers_per_cm[node]}, 5.0);
    }
};

TEST_F(PathIntegrator, WeighsLevelsSoThatCuttingASegmentChangesNothing) {
    const auto whole = levelWeights(pathOf({vertical(air_, 1000.0, 1200.0)}), air_.levelCount());
    const auto cut =
        levelWeights(pathOf({vertical(air_, 1000.0, 1070.0), vertical(air_, 1070.0, 1200.0)}),
                     air_.levelCount());
    for (std::size_t level = 0; level < whole.size(); ++level) {
        EXPECT_NEAR(whole[level], cut[level], 1e-9);
    }
    EXPECT_NEAR(whole[5], 100.0, 1e-9);
    EXPECT_NEAR(whole[6], 100.0, 1e-9);
}

TEST_F(PathIntegrator, IntegratesASourceThatIsLinearInOpticalDepth) {
    // L = B0 (1 - e^-t) + (B1 - B0) ((1 - e^-t) / t - e^-t); lengths make the depth what it shall.
    const NodeColumn column = this->column(medium);
    RaySegment segment = vertical(air_, 1000.0, 1200.0);
    const double perMetre = 0.5 * static_cast<double>(column.extinction(5)[0]) +
                            0.5 * static_cast<double>(column.extinction(6)[0]);
    const double near = column.planck(5)[0], far = column.planck(6)[0];
    for (const double t : {1e-12, 1e-6, 0.0299999, 0.0300001, 0.5, 4.0, 50.0, 1e5}) {
        segment.length_m = t / perMetre;
        const PathLight light = integratePath(column, pathOf({segment}), {});
        const long double x = static_cast<long double>(t), absorbed = -std::expm1(-x);
        const long double share =
            x < 1e-3L ? x / 2 - x * x / 3 + x * x * x / 8 : absorbed / x - std::exp(-x);
        // Scattering by molecules, which takes 1e-8 of the extinction here, is not given back.
        const auto expected = static_cast<double>(static_cast<long double>(near) * absorbed +
                                                  static_cast<long double>(far - near) * share);
        EXPECT_NEAR(light.radiance[0] / expected, 1.0, 1e-6) << t;
        EXPECT_NEAR(light.transmittance[0], std::exp(-t), 1e-14) << t;
    }
}

TEST_F(PathIntegrator, AddsWhatIsScatteredIntoThePath) {
    // Scattered light of mean 2 k and slope k against the vertical, k the extinction: a source of
    // 1 upwards against the sensor's view, 3 the other way, besides Planck's.
    const NodeColumn column = this->column(medium);
    const ScatteredEmission scattered = [&](std::size_t level, std::span<double> mean,
                                            std::span<double> slope) {
        mean[0] = 2.0 * static_cast<double>(column.extinction(level)[0]);
        slope[0] = static_cast<double>(column.extinction(level)[0]);
    };
    for (const bool isUp : {true, false}) {
        const double from_m = isUp ? 1050.0 : 1150.0, to_m = isUp ? 1150.0 : 1050.0;
        const RayPath path = pathOf({vertical(air_, from_m, to_m)});
        const PathLight with = integratePath(column, path, scattered);
        const PathLight without = integratePath(column, path, {});
        EXPECT_NEAR((with.radiance[0] - without.radiance[0]) / (1.0 - with.transmittance[0]),
                    isUp ? 1.0 : 3.0, 1e-6);
    }
}

TEST_F(PathIntegrator, InterpolatesLevelsSmoothlyAndWithoutOvershoot) {
    std::vector<double> values;
    for (std::size_t level = 0; level < air_.levelCount(); ++level) {
        values.push_back(level < 6    ? 1.0
                         : level == 6 ? 2.0
                                      : 5.0 + 0.01 * static_cast<double>(level));
    }
    const auto at = [&](double altitude_m) {
        std::vector<double> out(1);
        interpolateLevels(air_, values, altitude_m, out);
        return out[0];
    };
    for (std::size_t level = 0; level < values.size(); ++level) {
        EXPECT_NEAR(at(air_.altitudes_m()[level]), values[level], 1e-12);
    }
    double last = at(0.0);
    for (double z = 0.0; z <= 100e3; z += 37.0) {
        EXPECT_GE(at(z), last - 1e-12) << z;
        last = at(z);
    }
    EXPECT_EQ(at(200e3), values.back());
    const double slopeBelow = (at(1200.0) - at(1199.9)) / 0.1;
    const double slopeAbove = (at(1200.1) - at(1200.0)) / 0.1;
    EXPECT_NEAR(slopeBelow, slopeAbove, 1e-4);
}

} // namespace
} // namespace irsg
