#include "irsg/gas/NearestPoints.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

TEST(NearestPoints, AreThoseOfALookAtAll) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    std::vector<GasVector> places_m;
    places_m.reserve(751);
    for (int i = 0; i < 700; ++i) {
        places_m.push_back({anywhere(random), 0.1 * anywhere(random), anywhere(random)});
    }
    places_m.push_back(places_m.front()); // the same again
    for (int i = 0; i < 50; ++i) {
        places_m.push_back({0.5, anywhere(random), 0.5}); // on a line
    }
    const NearestPoints near(places_m);
    for (int look = 0; look < 200; ++look) {
        const GasVector to_m{1.4 * anywhere(random) - 0.2, anywhere(random), anywhere(random)};
        std::vector<double> expected;
        for (const auto& place_m : places_m) {
            double sum = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sum += (place_m[axis] - to_m[axis]) * (place_m[axis] - to_m[axis]);
            }
            expected.push_back(sum);
        }
        std::ranges::sort(expected);
        std::vector<NearestPoints::Found> found(12);
        ASSERT_EQ(near.nearest(to_m, found), found.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].distance2_m2, expected[i]) << look << " " << i;
        }
    }
}

TEST(NearestPoints, AreAllWhereThereAreFew) {
    const NearestPoints near({{1, 0, 0}, {0, 0, 0}});
    std::vector<NearestPoints::Found> found(5);
    ASSERT_EQ(near.nearest({0.2, 0, 0}, found), 2u);
    EXPECT_EQ(found[0].number, 1u);
    EXPECT_EQ(found[1].number, 0u);
    EXPECT_EQ(NearestPoints({}).nearest({0, 0, 0}, found), 0u);
}

} // namespace
