#include "irsg/image/ImageProfile.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

using testing::ElementsAre;

/// Each value is 10 y + x.
RadianceImage counted(int width, int height) {
    RadianceImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.primary().values[image.offset(x, y)] = static_cast<float>(10 * y + x);
        }
    }
    return image;
}

TEST(ImageProfile, GoesFromPixelToPixelEitherWay) {
    const RadianceImage image = counted(5, 4);
    const ImageProfile row = profileAlong(image, image.primary(), 1, 2, 4, 2);
    EXPECT_THAT(row.values, ElementsAre(21.0, 22.0, 23.0, 24.0));
    EXPECT_THAT(row.distance_px, ElementsAre(0.0, 1.0, 2.0, 3.0));
    const ImageProfile up = profileAlong(image, image.primary(), 3, 3, 3, 1);
    EXPECT_THAT(up.values, ElementsAre(33.0, 23.0, 13.0));
    EXPECT_THAT(up.y, ElementsAre(3, 2, 1));
}

TEST(ImageProfile, TakesThePixelsNextToALeaningLine) {
    const RadianceImage image = counted(5, 4);
    // (0,0) to (4,2): y is 0, 0.5, 1, 1.5, 2, and halves go away from 0.
    const ImageProfile line = profileAlong(image, image.primary(), 0, 0, 4, 2);
    EXPECT_THAT(line.x, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(line.y, ElementsAre(0, 1, 1, 2, 2));
    EXPECT_DOUBLE_EQ(line.distance_px.back(), std::hypot(4.0, 2.0));
    ImageProfile back = profileAlong(image, image.primary(), 4, 2, 0, 0);
    EXPECT_DOUBLE_EQ(back.distance_px.back(), line.distance_px.back());
    EXPECT_EQ(back.values.front(), line.values.back());
}

TEST(ImageProfile, OfOnePixelHasOneValue) {
    RadianceImage image = counted(3, 3);
    image.primary().values[4] = std::nanf("");
    const ImageProfile point = profileAlong(image, image.primary(), 1, 1, 1, 1);
    ASSERT_EQ(point.values.size(), 1u);
    EXPECT_TRUE(std::isnan(point.values[0]));
    EXPECT_EQ(point.distance_px[0], 0.0);
}

TEST(ImageProfile, RefusesPixelsThatThereAreNot) {
    const RadianceImage image = counted(3, 2);
    try {
        profileAlong(image, image.primary(), 0, 0, 3, 0);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("pixel 3, 0"));
        EXPECT_THAT(error.what(), testing::HasSubstr("3 x 2"));
    }
    EXPECT_THROW(profileAlong(image, image.primary(), -1, 0, 2, 0), InputError);
    const ImageChannel other{"other", "", {1.0F}};
    EXPECT_THROW(profileAlong(image, other, 0, 0, 1, 0), LogicError);
}

} // namespace
} // namespace irsg
