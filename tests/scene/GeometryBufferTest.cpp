// What the factors of a view are kept in: fields, fronts, rows, and the walk through layers.
#include "irsg/radiance/GeometryBuffer.h"

#include <bit>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/render/sampling/LayerSort.h"

using namespace irsg;

namespace {

/// Rows of two entities: a solid (drawn row 0), a gas (1), and of the second entity a glass (2).
SurfaceRows someRows(std::vector<SliceNodes> slices = {{}, {}}) {
    return {{{0, {1, 1}}, {0, {2, 2}}, {1, {1, 7}}}, {false, true, true}, std::move(slices)};
}

struct Visit {
    SurfaceStackId kind;
    float weight;
    bool operator==(const Visit&) const = default;
};

std::vector<Visit> visitsOf(LayerWalk& walk, const std::vector<std::int32_t>& drawn,
                            const std::vector<float>& distances_m) {
    // One sample whose layers were all listed, the nearest last.
    GeometrySamples samples;
    samples.factorCount = 3;
    samples.opaque = {0.0f, 0.0f, 0.0f, 0.0f};
    std::vector<float> list;
    for (std::size_t i = drawn.size(); i-- > 0;) {
        for (const float word :
             {std::bit_cast<float>(0u), 1.0f / static_cast<float>(i + 1),
              static_cast<float>(drawn[i] + 1), distances_m[i], 0.0f, 0.0f, 0.0f, 0.0f}) {
            list.push_back(word);
        }
    }
    gatherFragments(list, samples);
    sortLayers(samples, 10);
    std::vector<Visit> visits;
    walk.forEachLayer(
        samples, 0,
        [&](const SurfaceStackId& kind, float weight, const GeometrySamples::Layer&) {
            visits.push_back({kind, weight});
        },
        [](const SurfaceStackId&, float, const GeometrySamples::Layer&) {
            FAIL() << "without gas nothing is received apart";
        });
    return visits;
}

} // namespace

TEST(GeometryBuffer, KeepsSumsByCellAndKindWhateverTheOrder) {
    GeometryBuffer<double> field(3, 2);
    const int a = field.kindOf({0, 4}), b = field.kindOf({2, 1});
    EXPECT_EQ(field.kindOf({0, 4}), a);
    EXPECT_NE(a, b);
    for (const auto& [cell, kind] : {std::pair{2, a}, {0, b}, {2, b}, {2, a}, {0, b}}) {
        double* sums = field.at(static_cast<std::size_t>(cell), kind);
        sums[0] += 1.0;
        sums[1] += 10.0 * cell;
    }
    std::vector<std::tuple<std::size_t, int, double, double>> found;
    for (std::size_t cell = 0; cell < 3; ++cell) {
        field.forEach(cell, [&](std::size_t kind, std::span<const double> numbers) {
            found.emplace_back(cell, static_cast<int>(kind), numbers[0], numbers[1]);
        });
    }
    EXPECT_EQ(found, (std::vector<std::tuple<std::size_t, int, double, double>>{
                         {0, b, 2.0, 0.0}, {2, a, 2.0, 40.0}, {2, b, 1.0, 20.0}}));
}

TEST(GeometryBuffer, AddsAnotherWithItsOwnNumbers) {
    GeometryBuffer<float> part(2, 1), whole(4, 1);
    *part.at(1, part.kindOf({1, 3})) += 2.0F;
    *part.at(0, part.kindOf({0, 3})) += 5.0F;
    *whole.at(3, whole.kindOf({6, 3})) += 1.0F;
    whole.add(
        part, [](std::size_t cell) { return cell + 2; },
        [](int stack) { return stack == 1 ? 6 : 0; });
    float atThree = 0.0F, atTwo = 0.0F;
    whole.forEach(3, [&](std::size_t kind, std::span<const float> numbers) {
        EXPECT_EQ(whole.kinds()[kind], (SurfaceStackId{6, 3}));
        atThree += numbers[0];
    });
    whole.forEach(2, [&](std::size_t kind, std::span<const float> numbers) {
        EXPECT_EQ(whole.kinds()[kind], (SurfaceStackId{0, 3}));
        atTwo += numbers[0];
    });
    EXPECT_EQ(atThree, 3.0F);
    EXPECT_EQ(atTwo, 5.0F);
}

TEST(OccluderStacks, AreSetsInWhichTheOrderDoesNotMatterButTheNumberDoes) {
    OccluderStacks occluderStacks;
    const OccluderMaterial gas{0, 2}, glass{1, 7};
    const int gasThenGlass = occluderStacks.behind(occluderStacks.behind(0, gas), glass);
    EXPECT_EQ(gasThenGlass, occluderStacks.behind(occluderStacks.behind(0, glass), gas));
    EXPECT_NE(gasThenGlass, occluderStacks.behind(gasThenGlass, gas));
    EXPECT_EQ(occluderStacks.materials(gasThenGlass), (std::vector<OccluderMaterial>{gas, glass}));
    EXPECT_EQ(occluderStacks.numberOf({gas, glass}), gasThenGlass);
    EXPECT_TRUE(occluderStacks.materials(0).empty());
}

TEST(LayerWalk, KnowsWhatLiesBeforeEachLayer) {
    const SurfaceRows rows = someRows();
    LayerWalk walk(rows);
    const auto visits = visitsOf(walk, {1, 2, 1, 0}, {1, 2, 3, 4});
    ASSERT_EQ(visits.size(), 4U);
    EXPECT_EQ(visits[0].kind, (SurfaceStackId{0, 1}));
    EXPECT_EQ(walk.occluderStacks().materials(visits[1].kind.stack),
              (std::vector<OccluderMaterial>{{0, 2}}));
    EXPECT_EQ(walk.occluderStacks().materials(visits[2].kind.stack),
              (std::vector<OccluderMaterial>{{0, 2}, {1, 7}}));
    EXPECT_EQ(walk.occluderStacks().materials(visits[3].kind.stack),
              (std::vector<OccluderMaterial>{{0, 2}, {0, 2}, {1, 7}}));
}

TEST(LayerWalk, DividesASampleBetweenTheNodesAroundIt) {
    const SurfaceRows rows = someRows({{}, {100.0, 250.0, 400.0}});
    EXPECT_EQ(rows.size(), 5);
    EXPECT_TRUE(rows.isSliced());
    LayerWalk walk(rows);
    EXPECT_EQ(visitsOf(walk, {2}, {175.0F}), (std::vector<Visit>{{{0, 2}, 0.5F}, {{0, 3}, 0.5F}}));
    EXPECT_EQ(visitsOf(walk, {2}, {362.5F}),
              (std::vector<Visit>{{{0, 3}, 0.25F}, {{0, 4}, 0.75F}}));
    // Beyond the ends by rounding.
    EXPECT_EQ(visitsOf(walk, {2}, {99.0F}), (std::vector<Visit>{{{0, 2}, 1.0F}, {{0, 3}, 0.0F}}));
    EXPECT_EQ(visitsOf(walk, {2}, {401.0F}), (std::vector<Visit>{{{0, 3}, 0.0F}, {{0, 4}, 1.0F}}));
    EXPECT_EQ(visitsOf(walk, {0}, {350.0F}), (std::vector<Visit>{{{0, 0}, 1.0F}}));
}
