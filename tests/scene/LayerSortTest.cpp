// Fragments come in whatever order they were drawn and leave by sample, near to far.
#include "irsg/render/sampling/LayerSort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

struct Fragment {
    std::uint32_t sample;
    float depth, row, distance_m, factor;
    /// By sample, near to far, then by value.
    auto key() const { return std::tuple(sample, -depth, row, distance_m, factor); }
    bool operator==(const Fragment&) const = default;
};

std::vector<float> listOf(const std::vector<Fragment>& fragments) {
    std::vector<float> list;
    for (const Fragment& f : fragments) {
        for (const float word : {std::bit_cast<float>(f.sample), f.depth, f.row, f.distance_m,
                                 f.factor, 0.0f, 0.0f, 0.0f}) {
            list.push_back(word);
        }
    }
    return list;
}

GeometrySamples sorted(const std::vector<Fragment>& fragments, std::size_t samples, int layers) {
    GeometrySamples result;
    result.factorCount = 1;
    result.opaque.assign(4 * samples, 0.0f);
    gatherFragments(listOf(fragments), result);
    sortLayers(result, layers);
    return result;
}

std::vector<Fragment> someFragments(std::size_t count, std::uint32_t first, std::uint32_t last) {
    std::mt19937 random(7);
    std::vector<Fragment> all;
    for (std::size_t i = 0; i < count; ++i) {
        const auto draw = [&](std::uint32_t below) {
            return static_cast<std::uint32_t>(random() % below);
        };
        // Few depths, so that many are equal.
        all.push_back({first + draw(last - first), static_cast<float>(1 + draw(5)) / 8.0f,
                       static_cast<float>(1 + draw(3)), static_cast<float>(draw(100)),
                       static_cast<float>(draw(4)) / 4.0f});
    }
    return all;
}

} // namespace

TEST(LayerSort, PutsFragmentsInOrderBySampleAndDepth) {
    constexpr std::size_t samples = 60;
    std::vector<Fragment> fragments = someFragments(900, 11, 47);
    for (int i = 0; i < 100; ++i) { // far more in one sample than in others
        fragments.push_back({20, 1.0f / static_cast<float>(1 + (i * 37) % 100), 2.0f, 1.0f, 0.5f});
    }
    std::vector<Fragment> expected = fragments;
    std::ranges::sort(expected, {}, &Fragment::key);

    const GeometrySamples result = sorted(fragments, samples, 1000);
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const std::size_t before = next;
        result.forEachLayer(i, [&](const GeometrySamples::Layer& layer) {
            ASSERT_LT(next, expected.size());
            EXPECT_EQ(expected[next].sample, i);
            EXPECT_EQ(layer.row, static_cast<int>(expected[next].row) - 1);
            EXPECT_EQ(layer.distance_m, expected[next].distance_m);
            EXPECT_EQ(layer.factors[0], expected[next].factor);
            ++next;
        });
        EXPECT_EQ(result.isEmpty(i), next == before);
    }
    EXPECT_EQ(next, expected.size());
    EXPECT_EQ(result.layersLeftOver, 0);
}

TEST(LayerSort, DoesNotDependOnTheOrderOfDrawing) {
    std::vector<Fragment> fragments = someFragments(500, 0, 30);
    const GeometrySamples one = sorted(fragments, 30, 100);
    std::ranges::shuffle(fragments, std::mt19937(3));
    const GeometrySamples other = sorted(fragments, 30, 100);
    EXPECT_EQ(one.ends, other.ends);
    EXPECT_EQ(one.words.size(), other.words.size());
    for (std::size_t i = 0; i < one.words.size(); ++i) {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(one.words[i]),
                  std::bit_cast<std::uint32_t>(other.words[i]));
    }
}

TEST(LayerSort, LeavesTheFarthestOutAndCountsSuchSamples) {
    std::vector<Fragment> fragments;
    for (std::uint32_t sample : {2u, 5u, 6u}) {
        for (int i = 0; i < (sample == 5u ? 2 : 4); ++i) {
            fragments.push_back(
                {sample, 1.0f / static_cast<float>(1 + i), static_cast<float>(i + 1), 1.0f, 0.0f});
        }
    }
    const GeometrySamples result = sorted(fragments, 8, 3);
    EXPECT_EQ(result.layersLeftOver, 2);
    std::vector<int> rows;
    result.forEachLayer(2, [&](const GeometrySamples::Layer& layer) { rows.push_back(layer.row); });
    EXPECT_EQ(rows, (std::vector<int>{0, 1, 2}));
}

TEST(GeometrySamples, ShowTheOpaqueSurfaceLastWithAllItsFactors) {
    GeometrySamples samples;
    samples.factorCount = 6;
    samples.opaque = {0, 0, 0, 0, 3, 0.1f, 0.2f, 0.3f};
    samples.moreFactors = {0, 0, 0, 0, 0.4f, 0.5f, 0.6f, 0};
    samples.wordsPerFragment = 12;
    gatherFragments(std::vector<float>{std::bit_cast<float>(1u), 0.5f, 1.0f, 9.0f, 0.9f, 0.8f, 0.7f,
                                       0.6f, 0.5f, 0.4f, 0.0f, 0.0f},
                    samples);
    sortLayers(samples, 4);
    EXPECT_TRUE(samples.isEmpty(0));
    std::vector<std::pair<int, std::vector<float>>> seen;
    samples.forEachLayer(1, [&](const GeometrySamples::Layer& layer) {
        seen.emplace_back(layer.row,
                          std::vector<float>(layer.factors.begin(), layer.factors.end()));
    });
    EXPECT_EQ(seen, (std::vector<std::pair<int, std::vector<float>>>{
                        {0, {0.9f, 0.8f, 0.7f, 0.6f, 0.5f, 0.4f}},
                        {2, {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}}}));
}
