#include "irsg/image/HotSpots.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

using testing::ElementsAre;

class HotSpots : public testing::Test {
  protected:
    void put(int x, int y, float value) { image.primary().values[image.offset(x, y)] = value; }
    std::vector<HotSpot> found(std::size_t most = 10, int apart_px = 4) const {
        return hottestSpots(image, image.primary(), most, apart_px);
    }
    RadianceImage image{20, 16};
};

TEST_F(HotSpots, ComeLargestFirstWithTheirPlaces) {
    put(3, 4, 5.0F);
    put(15, 2, 9.0F);
    put(0, 15, 7.0F); // in a corner
    EXPECT_THAT(found(), ElementsAre(HotSpot{15, 2, 9.0}, HotSpot{0, 15, 7.0}, HotSpot{3, 4, 5.0}));
    EXPECT_THAT(found(2), ElementsAre(HotSpot{15, 2, 9.0}, HotSpot{0, 15, 7.0}));
    EXPECT_TRUE(found(0).empty());
}

TEST_F(HotSpots, NearASpotThereIsNoSecond) {
    put(5, 5, 9.0F);
    put(8, 5, 8.0F); // a maximum of its own, three pixels away
    put(9, 9, 7.0F); // four pixels away from the first in both, one from nobody
    EXPECT_THAT(found(10, 4), ElementsAre(HotSpot{5, 5, 9.0}, HotSpot{9, 9, 7.0}));
    EXPECT_EQ(found(10, 1).size(), 3u);
}

TEST_F(HotSpots, AFlatTopIsOneSpot) {
    for (int x = 4; x < 7; ++x) {
        put(x, 6, 3.0F);
    }
    EXPECT_THAT(found(), ElementsAre(HotSpot{4, 6, 3.0}));
}

TEST_F(HotSpots, AreNoneWhereAllIsEqualOrNotANumber) {
    EXPECT_TRUE(found().empty());
    put(3, 3, std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(found().empty()) << "beside it nothing is exceeded";
    put(10, 10, std::numeric_limits<float>::infinity());
    put(11, 10, 2.0F);
    EXPECT_THAT(found(), ElementsAre(HotSpot{11, 10, 2.0}));
}

TEST_F(HotSpots, RefusesAPlaneOfAnotherSize) {
    EXPECT_THROW(hottestSpots(image, {"other", "", {1.0F}}), LogicError);
    EXPECT_THROW(hottestSpots(image, image.primary(), 1, 0), LogicError);
}

} // namespace
} // namespace irsg
