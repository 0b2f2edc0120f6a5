#include "irsg/render/rays/FacetTree.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace irsg {
namespace {

/// Boxes of facets on a sphere of 1 m, of which every seventh is not there.
std::vector<FacetTree::Box> boxesOnASphere(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    std::vector<FacetTree::Box> boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 middle = normalized({within(random), within(random), within(random)});
        for (int corner = 0; corner < 3 && i % 7 != 3; ++corner) {
            boxes[i].include(
                middle + Vec3{0.02 * within(random), 0.02 * within(random), 0.02 * within(random)});
        }
    }
    return boxes;
}

double reachOf(const FacetTree::Box& box, const Vec3& along, bool isMost) {
    const auto of = [&](std::size_t axis, double component) {
        const double a = static_cast<double>(box.min[axis]) * component,
                     b = static_cast<double>(box.max[axis]) * component;
        return isMost ? std::max(a, b) : std::min(a, b);
    };
    return of(0, along.x) + of(1, along.y) + of(2, along.z);
}

TEST(FacetTree, FindsTheBoxesThatTouchOneAsALookAtAllOfThemDoes) {
    for (const std::size_t count : {0, 1, 4, 5, 1000}) {
        const auto boxes = boxesOnASphere(count);
        const FacetTree tree(boxes);
        std::size_t found = 0;
        for (int i = 0; i < 50; ++i) {
            const Vec3 at{std::cos(0.3 * i), std::sin(0.3 * i), 0.04 * i - 1.0};
            const Vec3 size{0.2, 0.1, 0.3};
            const BoundingBox about{at - size, at + size};
            std::vector<std::uint32_t> expected, numbers;
            for (std::uint32_t b = 0; b < count; ++b) {
                if (boxes[b].isThere() && FacetTree::touch(boxes[b], about)) {
                    expected.push_back(b);
                }
            }
            tree.forEachTouching(about, [&](std::uint32_t number, const FacetTree::Box& box) {
                numbers.push_back(number);
                EXPECT_EQ(box.min, boxes[number].min);
                EXPECT_EQ(box.max, boxes[number].max);
            });
            std::ranges::sort(numbers);
            EXPECT_EQ(numbers, expected) << count;
            found += numbers.size();
        }
        EXPECT_GE(found, count >= 1000 ? 100u : 0u);
    }
}

TEST(FacetTree, SaysOfAPlaneWhetherBoxesBeyondItAreManyOrAreTaken) {
    constexpr double margin_m = 1e-3;
    std::size_t many = 0, taken = 0, none = 0;
    for (const std::size_t count : {1, 5, 200, 3000}) {
        const auto boxes = boxesOnASphere(count);
        const FacetTree tree(boxes);
        for (int i = 0; i < 100; ++i) {
            const Vec3 normal = normalized({std::cos(1.0 * i), std::sin(1.0 * i), 0.02 * i - 1.0});
            const double offset_m = 1.02 - 0.004 * i;
            // Every fifth of those that reach beyond is taken, one of eleven of the whole ones.
            const auto isTaken = [](std::uint32_t number, bool isWhole) {
                return isWhole ? number % 11 == 5 : number % 5 == 2;
            };
            std::size_t reaching = 0;
            bool mayBe = false, mustBe = false;
            for (std::uint32_t b = 0; b < count; ++b) {
                if (!boxes[b].isThere() || !(reachOf(boxes[b], normal, true) > offset_m)) {
                    continue;
                }
                ++reaching;
                const bool isWhole = reachOf(boxes[b], normal, false) > offset_m + margin_m;
                mustBe = mustBe || isTaken(b, false) || (isWhole && isTaken(b, true));
            }
            mayBe = mustBe || reaching > FacetTree::mostLooks;
            const bool is = tree.isAnyBeyond(
                normal, offset_m, margin_m, [&](std::uint32_t number, bool isWhole) {
                    EXPECT_TRUE(boxes[number].isThere());
                    EXPECT_GT(reachOf(boxes[number], normal, true), offset_m);
                    if (isWhole) {
                        EXPECT_GT(reachOf(boxes[number], normal, false), offset_m + margin_m);
                    }
                    return isTaken(number, isWhole);
                });
            EXPECT_EQ(is, mayBe) << count << " boxes, " << reaching << " beyond";
            many += reaching > FacetTree::mostLooks ? 1 : 0;
            taken += reaching <= FacetTree::mostLooks && is ? 1 : 0;
            none += reaching > 0 && !is ? 1 : 0;
        }
    }
    EXPECT_GT(many, 5u);
    EXPECT_GT(taken, 5u);
    EXPECT_GT(none, 5u);
}

} // namespace
} // namespace irsg
