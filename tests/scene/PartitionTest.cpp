#include "irsg/render/sampling/Partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace irsg;

namespace {

double area_px2(const ImageRectangle& r) {
    return r.empty() ? 0.0 : r.width() * r.height();
}

std::vector<ImageRectangle> randomThings(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.0, 100.0), size(0.1, 6.0);
    std::vector<ImageRectangle> things;
    for (std::size_t i = 0; i < count; ++i) {
        const double left = place(random), top = place(random);
        things.push_back({left, top, left + size(random), top + size(random)});
    }
    return things;
}

} // namespace

TEST(Partition, HoldsAllThingsInRectanglesThatDoNotOverlap) {
    for (const std::size_t count : {1u, 2u, 7u, 40u, 300u}) {
        for (unsigned seed = 0; seed < 5; ++seed) {
            const std::vector<ImageRectangle> things = randomThings(count, seed);
            const std::vector<Enclosure> parts = partition(things, 1.25, 64);
            EXPECT_LE(parts.size(), 64u);
            std::vector<double> held_px2(count);
            for (std::size_t i = 0; i < parts.size(); ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    EXPECT_LT(area_px2(parts[i].rectangle.intersectedWith(parts[k].rectangle)),
                              1e-9);
                }
                for (const std::size_t thing : parts[i].things) {
                    held_px2[thing] += area_px2(parts[i].rectangle.intersectedWith(things[thing]));
                }
            }
            for (std::size_t thing = 0; thing < count; ++thing) {
                EXPECT_NEAR(held_px2[thing], area_px2(things[thing]), 1e-9) << thing;
            }
        }
    }
}

TEST(Partition, CutsOnlyWhereThatSparesEnough) {
    const ImageRectangle a{0, 0, 10, 10}, beside{10.5, 0, 20.5, 10}, far{100, 0, 110, 10};
    ASSERT_EQ(partition({a, beside}, 1.25, 64).size(), 1u) << "5 % would be spared";
    EXPECT_EQ(partition({a, beside}, 1.25, 64).front().things.size(), 2u);
    ASSERT_EQ(partition({a, far}, 1.25, 64).size(), 2u);
    EXPECT_EQ(partition({a, beside, far}, 1.25, 64).size(), 2u);
}

TEST(Partition, KeepsToTheMostAndDoesNotMindTheOrder) {
    std::vector<ImageRectangle> things = randomThings(200, 3);
    const std::vector<Enclosure> parts = partition(things, 1.25, 8);
    EXPECT_LE(parts.size(), 8u);
    std::ranges::reverse(things);
    const std::vector<Enclosure> reversed = partition(things, 1.25, 8);
    ASSERT_EQ(reversed.size(), parts.size());
    const auto sorted = [](const std::vector<Enclosure>& all) {
        std::vector<std::vector<double>> places;
        for (const Enclosure& one : all) {
            places.push_back(
                {one.rectangle.left, one.rectangle.top, one.rectangle.right, one.rectangle.bottom});
        }
        std::ranges::sort(places);
        return places;
    };
    EXPECT_EQ(sorted(reversed), sorted(parts));
    EXPECT_TRUE(partition({}, 1.25, 8).empty());
}
