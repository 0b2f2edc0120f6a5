#include <gtest/gtest.h>

#include "irsg/image/SampledTiles.h"

using namespace irsg;

TEST(SampledTiles, AreToldByTheImageAndReadBack) {
    const std::vector<SampledTile> tiles = {
        {12.5, 0.0, 639.0625, 511.96875, 25.0, 26.0, "hull, mast of the ship"},
        {-1e-7, 3.0, 4.0, 5.0, 1.5e6, 2.0, "plane"},
        {7.0, 8.0, 7.25, 8.25, 0.0, 0.0, ""}};
    RadianceImage image(4, 3);
    EXPECT_TRUE(tilesOf(image).empty());
    describeTiles(tiles, image);
    EXPECT_EQ(tilesOf(image), tiles);
    describeTiles({}, image);
    EXPECT_FALSE(image.attributes.contains("windows"));
}

TEST(SampledTiles, OfAnotherProgramAreLeftAlone) {
    RadianceImage image(4, 3);
    for (const char* text : {"3 panes", "1 2 3 4 5", "1 2 3 4 5 6 hull\nand so on\n"}) {
        image.attributes["windows"] = text;
        EXPECT_TRUE(tilesOf(image).empty()) << text;
    }
}
