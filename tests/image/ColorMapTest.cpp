#include "irsg/image/ColorMap.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {

void PrintTo(const Rgb& c, std::ostream* out) {
    *out << "rgb(" << +c.red << ", " << +c.green << ", " << +c.blue << ")";
}

namespace {

using test::inputErrorOf;
using testing::HasSubstr;

TEST(ColorMap, OffersTheMapsOfTheFieldWhiteHotFirst) {
    EXPECT_THAT(ColorMap::names(), testing::ElementsAre("white-hot", "black-hot", "ironbow",
                                                        "inferno", "viridis", "diverging"));
    EXPECT_EQ(ColorMap::names().front(), ColorMap::defaultName);
}

TEST(ColorMap, HasItsEndAndCentreColours) {
    const struct {
        const char* name;
        Rgb low, middle, high;
    } rows[] = {
        {"white-hot", {0, 0, 0}, {128, 128, 128}, {255, 255, 255}},
        {"black-hot", {255, 255, 255}, {128, 128, 128}, {0, 0, 0}},
        {"ironbow", {0, 0, 0}, {186, 37, 95}, {255, 255, 246}},
        {"inferno", {0, 0, 4}, {186, 56, 84}, {252, 255, 164}},
        {"viridis", {68, 1, 84}, {34, 144, 140}, {253, 231, 37}},
        {"diverging", {22, 62, 158}, {255, 255, 255}, {136, 20, 38}},
    };
    for (const auto& row : rows) {
        const ColorMap& map = ColorMap::named(row.name);
        EXPECT_EQ(map.at(0.0), row.low) << row.name;
        EXPECT_EQ(map.at(1.0), row.high) << row.name;
        const Rgb centre = map.at(0.5);
        EXPECT_NEAR(centre.red, row.middle.red, 8) << row.name;
        EXPECT_NEAR(centre.green, row.middle.green, 8) << row.name;
        EXPECT_NEAR(centre.blue, row.middle.blue, 8) << row.name;
    }
}

TEST(ColorMap, GreyIsTheByteOfTheValue) {
    for (int i = 0; i <= 255; ++i) {
        const auto grey = static_cast<std::uint8_t>(i);
        EXPECT_EQ(ColorMap::named("white-hot").at(i / 255.0), (Rgb{grey, grey, grey}));
    }
}

TEST(ColorMap, LightnessKnowsTheGreysOfTheStandard) {
    EXPECT_NEAR(lightness({0, 0, 0}), 0.0, 1e-9);
    EXPECT_NEAR(lightness({255, 255, 255}), 100.0, 1e-3);
    EXPECT_NEAR(lightness({119, 119, 119}), 50.03, 0.02);
    EXPECT_NEAR(lightness({255, 0, 0}), 53.24, 0.02);
    EXPECT_NEAR(lightness({0, 0, 255}), 32.30, 0.02);
}

TEST(ColorMap, LightnessRisesAllTheWayWhereOrderMatters) {
    // Rounding to bytes may take back a fraction of one level, not more.
    for (const char* name : {"white-hot", "ironbow", "inferno", "viridis"}) {
        const auto& table = ColorMap::named(name).table();
        double highest = lightness(table.front());
        for (const Rgb& color : table) {
            EXPECT_GE(lightness(color), highest - 0.4) << name;
            highest = std::max(highest, lightness(color));
        }
        for (int i = 0; i < 50; ++i) {
            EXPECT_LT(lightness(ColorMap::named(name).at(i / 50.0)),
                      lightness(ColorMap::named(name).at((i + 1) / 50.0)))
                << name << " " << i;
        }
    }
}

TEST(ColorMap, DivergingIsAsLightOnBothSidesOfItsWhiteCentre) {
    const ColorMap& map = ColorMap::named("diverging");
    EXPECT_TRUE(map.isDiverging());
    for (int i = 0; i < 25; ++i) {
        EXPECT_LT(lightness(map.at(i / 50.0)), lightness(map.at((i + 1) / 50.0)));
        EXPECT_NEAR(lightness(map.at(i / 50.0)), lightness(map.at(1.0 - i / 50.0)), 3.0) << i;
    }
    EXPECT_GT(map.at(0.1).blue, map.at(0.1).red);
    EXPECT_GT(map.at(0.9).red, map.at(0.9).blue);
    EXPECT_EQ(map.color(0.0, {-3.0, 3.0}), (Rgb{255, 255, 255}));
}

TEST(ColorMap, SpecialColoursAreNotInTheMapAndNotAlike) {
    const auto distance = [](Rgb a, Rgb b) {
        return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
    };
    for (const std::string& name : ColorMap::names()) {
        const ColorMap& map = ColorMap::named(name);
        const Rgb special[] = {map.below(), map.above(), map.notANumber()};
        for (std::size_t i = 0; i < 3; ++i) {
            double nearest = 1e9;
            for (const Rgb& color : map.table()) {
                nearest = std::min(nearest, distance(special[i], color));
            }
            EXPECT_GT(nearest, 60.0) << name << " " << i;
            EXPECT_GT(distance(special[i], special[(i + 1) % 3]), 60.0) << name << " " << i;
        }
    }
}

TEST(ColorMap, PlacesValuesBetweenTheLimits) {
    const ColorMap& map = ColorMap::named("white-hot");
    const DisplayLimits limits{.low = 10.0, .high = 20.0, .marksOutside = true};
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(map.color(10.0, limits), map.at(0.0));
    EXPECT_EQ(map.color(20.0, limits), map.at(1.0));
    EXPECT_EQ(map.color(14.0, limits), map.at(0.4));
    EXPECT_EQ(map.color(9.999, limits), map.below());
    EXPECT_EQ(map.color(-inf, limits), map.below());
    EXPECT_EQ(map.color(20.001, limits), map.above());
    EXPECT_EQ(map.color(inf, limits), map.above());
    EXPECT_EQ(map.color(std::nan(""), limits), map.notANumber());
    // By itself what is outside saturates; what is no number never does.
    const DisplayLimits plain{10.0, 20.0};
    EXPECT_EQ(map.color(9.999, plain), map.at(0.0));
    EXPECT_EQ(map.color(-inf, plain), map.at(0.0));
    EXPECT_EQ(map.color(inf, plain), map.at(1.0));
    EXPECT_EQ(map.color(std::nan(""), plain), map.notANumber());
    EXPECT_EQ(map.at(-5.0), map.at(0.0));
    EXPECT_EQ(map.at(5.0), map.at(1.0));
    EXPECT_EQ(map.at(std::nan("")), map.notANumber());
}

TEST(ColorMap, RefusesAnUnknownNameAndListsTheKnown) {
    const std::string message = inputErrorOf([] { ColorMap::named("jet"); });
    EXPECT_THAT(message, HasSubstr("'jet'"));
    EXPECT_THAT(message, HasSubstr("white-hot, black-hot, ironbow"));
}

} // namespace
} // namespace irsg
