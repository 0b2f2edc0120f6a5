#include "irsg/image/RadianceImage.h"

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

TEST(RadianceImage, StartsWithOnePlaneOfZeroRadiance) {
    const RadianceImage image(3, 2);
    EXPECT_EQ(image.width(), 3);
    EXPECT_EQ(image.height(), 2);
    EXPECT_EQ(image.pixelCount(), 6U);
    ASSERT_EQ(image.channels.size(), 1U);
    EXPECT_EQ(image.primary().name, "L");
    EXPECT_EQ(image.primary().unit, "W m-2 sr-1");
    EXPECT_EQ(image.primary().values, std::vector<float>(6, 0.0F));
}

TEST(RadianceImage, StoresTheTopRowFirstAndRowsFromTheLeft) {
    RadianceImage image(3, 2);
    image.primary().values = {1, 2, 3, 4, 5, 6};
    EXPECT_EQ(image.at(0, 0), 1.0F);
    EXPECT_EQ(image.at(2, 0), 3.0F);
    EXPECT_EQ(image.at(0, 1), 4.0F);
    EXPECT_EQ(image.offset(2, 1), 5U);
}

TEST(RadianceImage, ReturnsTheChannelThatIsThereAlready) {
    RadianceImage image(2, 2);
    image.channel("range", "m").values[3] = 7.0F;
    EXPECT_EQ(image.channel("range", "ignored").values[3], 7.0F);
    EXPECT_EQ(image.channels.size(), 2U);
    ASSERT_NE(image.find("range"), nullptr);
    EXPECT_EQ(image.find("range")->unit, "m");
    EXPECT_EQ(image.find("alpha"), nullptr);
}

TEST(RadianceImage, ADefaultImageIsEmptyAndShowsNothing) {
    RadianceImage image;
    EXPECT_TRUE(image.empty());
    EXPECT_EQ(image.pixelCount(), 0U);
    EXPECT_THROW(image.primary(), LogicError);
    EXPECT_THROW(std::as_const(image).primary(), LogicError);
    EXPECT_THROW(image.channel("L"), LogicError);
}

TEST(RadianceImage, RefusesSizesWithoutPixels) {
    EXPECT_THROW(RadianceImage(0, 5), LogicError);
    EXPECT_THROW(RadianceImage(5, 0), LogicError);
    EXPECT_THROW(RadianceImage(-1, 5), LogicError);
}

} // namespace
} // namespace irsg
