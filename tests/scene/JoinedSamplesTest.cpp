// Samples of smooth surfaces that stand for four: which they are, and that sums stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/TileSamples.h"
#include "irsg/render/sampling/JoinedSamples.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// A tile of 40 x 64 blocks of 2 x 2 samples that shows a tilted plane, whose second half has
/// another row, and a factor that is linear over it.
struct PlaneSamples {
    explicit PlaneSamples(int samplesOfBlock = 2) {
        tile.blocksWide = 40, tile.blocksHigh = 128 / samplesOfBlock;
        tile.samplesAcross = 2;
        tile.samplesDown = samplesOfBlock;
        scene.camera = &camera;
        const auto count =
            static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
        samples.width = tile.width(), samples.height = tile.height();
        samples.factorCount = 1;
        samples.opaque.assign(4 * count, 0.0f);
        samples.distances_m.assign(count, 0.0f);
        for (int row = 0; row < tile.height(); ++row) {
            for (int column = 0; column < tile.width(); ++column) {
                const std::size_t i = indexOf(tile, column, row);
                samples.opaque[4 * i] = column < 40 ? 1.0f : 2.0f;
                samples.opaque[4 * i + 1] = factorOf(column, row);
                samples.distances_m[i] = 100.0f + 0.5f * static_cast<float>(column) * sampleWidth_m;
            }
        }
        samples.ends.assign(count + 1, 0);
    }
    static float factorOf(int column, int row) {
        return 0.2f + 0.005f * static_cast<float>(column) + 0.002f * static_cast<float>(row);
    }
    void join(double mostDifference) {
        JoinLimits limits;
        limits.mostDifference = limits.mostBend = {mostDifference, mostDifference};
        limits.firstNormal = 1;
        limits.isGas = {false, false, isGas};
        joinSmoothSamples({SampleSheet::of(tile), {scene}}, limits, samples);
    }
    /// Puts the two walls of something before each sample, so far from each other.
    template <typename Length>
    void putWallsBefore(const Length& length_m) {
        for (int row = tile.height(); row-- > 0;) { // samples go from the bottom up
            for (int column = 0; column < tile.width(); ++column) {
                for (const float distance_m : {50.0f, 50.0f + length_m(column)}) {
                    samples.words.insert(samples.words.end(),
                                         {0.0f, 0.0f, 3.0f, distance_m, 0.0f, 0.0f, 0.0f, 0.0f});
                }
                samples.ends[indexOf(tile, column, row) + 1] =
                    static_cast<std::uint32_t>(samples.words.size() / 8);
            }
        }
        samples.highest = samples.size();
        samples.maximumLayers = 64;
    }
    /// Of the factor, each sample times the number of those that it stands for.
    double sum() const {
        double all = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!samples.isEmpty(i)) {
                all += static_cast<double>(samples.opaque[4 * i + 1]) *
                       (samples.standsForGroup(i) ? 4.0 : 1.0);
            }
        }
        return all;
    }
    std::size_t groups() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            count += samples.standsForGroup(i) ? 1 : 0;
        }
        return count;
    }

    bool isGas = true; ///< what the third row bounds
    static constexpr float sampleWidth_m = 0.1f;
    CameraFrame camera{sensorOf(40, 64, degrees(2.0 * std::atan(0.04))), Viewpoint{}};
    SampleTile tile;
    SurfaceScene scene;
    GeometrySamples samples;
};

} // namespace

TEST(JoinedSamplesTest, OfASmoothPlaneNearlyAllStandForFourAndSumsStay) {
    PlaneSamples plane;
    const double before = plane.sum();
    plane.join(0.2);
    EXPECT_NEAR(plane.sum() / before, 1.0, 1e-6);
    // Without the borders of eight parts and of the tile.
    EXPECT_GT(4 * plane.groups(), plane.samples.size() * 6 / 10);
    std::array<std::size_t, 4> ofNumber{};
    for (std::size_t i = 0; i < plane.samples.size(); ++i) {
        if (!plane.samples.standsForGroup(i)) {
            continue;
        }
        ++ofNumber[static_cast<std::size_t>(plane.samples.groups[i]) - 1];
        for (const std::size_t member : plane.samples.groupOf(i, plane.tile.stride())) {
            EXPECT_EQ(plane.samples.opaque[4 * member], plane.samples.opaque[4 * i]);
            EXPECT_EQ(plane.samples.isEmpty(member), member != i);
        }
    }
    const auto groups = static_cast<double>(plane.groups());
    for (const std::size_t number : ofNumber) {
        EXPECT_NEAR(static_cast<double>(number), 0.25 * groups, 0.1 * groups);
    }
}

TEST(JoinedSamplesTest, BehindGasAreThoseWithAboutTheSameLengthOfIt) {
    PlaneSamples bare;
    bare.join(0.2);
    const auto groupsBehind = [](bool isGas, float steep, std::vector<int> gasesAboutEye = {}) {
        PlaneSamples plane;
        plane.isGas = isGas;
        plane.samples.gasesAboutEye = std::move(gasesAboutEye);
        plane.putWallsBefore(
            [&](int column) { return 1.0f + steep * static_cast<float>(column % 2); });
        const double before = plane.sum();
        plane.join(0.2);
        EXPECT_NEAR(plane.sum() / before, 1.0, 1e-6);
        return plane.groups();
    };
    EXPECT_EQ(groupsBehind(true, 0.1f), bare.groups());
    EXPECT_EQ(groupsBehind(true, 0.3f), 0u) << "1 and 1.3 m";
    EXPECT_EQ(groupsBehind(false, 0.0f), 0u) << "a pane";
    EXPECT_EQ(groupsBehind(true, 0.0f, {2}), 0u) << "the eye is in gas";
}

TEST(JoinedSamplesTest, NoneAreOfTwoPixels) {
    PlaneSamples one(1);
    one.join(0.2);
    EXPECT_EQ(one.groups(), 0u) << "a pixel has one row of samples";
    PlaneSamples plane;
    plane.join(0.2);
    plane.tile.forEachRun([&](std::size_t first, int count, int, int, double) {
        for (std::size_t i = first; i < first + static_cast<std::size_t>(count); ++i) {
            if (plane.samples.standsForGroup(i)) {
                const auto group = plane.samples.groupOf(i, plane.tile.stride());
                EXPECT_EQ(std::min(group[0], group[2]) % 2, 0u);
            }
        }
    });
}

TEST(JoinedSamplesTest, NoneOfTwoRowsNorOfASurfaceThatBendsNorOfOneBehindAnother) {
    PlaneSamples bent;
    bent.join(0.004);
    EXPECT_EQ(bent.groups(), 0u) << "factors differ by 0.007 within a group";

    PlaneSamples stepped;
    for (int row = 0; row < stepped.tile.height(); ++row) {
        for (int column = 21; column < stepped.tile.width(); ++column) {
            stepped.samples.distances_m[indexOf(stepped.tile, column, row)] += 5.0f;
        }
    }
    stepped.join(0.2);
    for (std::size_t i = 0; i < stepped.samples.size(); ++i) {
        if (!stepped.samples.standsForGroup(i)) {
            continue;
        }
        const auto group = stepped.samples.groupOf(i, stepped.tile.stride());
        EXPECT_NEAR(static_cast<double>(stepped.samples.distances_m[group[0]]),
                    static_cast<double>(stepped.samples.distances_m[group[1]]), 1.0);
    }
}

TEST(JoinedSamplesTest, WhatIsFoundForOneIsGivenToTheFour) {
    PlaneSamples plane;
    plane.join(0.2);
    RadianceSamples radiances;
    radiances.planes.assign(2 * plane.samples.size(), 0.0f);
    for (std::size_t i = 0; i < plane.samples.size(); ++i) {
        if (!plane.samples.isEmpty(i)) {
            radiances.planes[2 * i] = plane.samples.opaque[4 * i + 1],
                                 radiances.planes[2 * i + 1] = 1.0f;
        }
    }
    giveToGroups(SampleSheet::of(plane.tile), plane.samples, radiances);
    for (int row = 0; row < plane.tile.height(); ++row) {
        for (int column = 0; column < plane.tile.width(); ++column) {
            const std::size_t i = indexOf(plane.tile, column, row);
            EXPECT_NEAR(static_cast<double>(radiances.planes[2 * i]),
                        static_cast<double>(PlaneSamples::factorOf(column, row)), 0.0041);
            EXPECT_EQ(radiances.planes[2 * i + 1], 1.0f);
        }
    }
}
