#include "irsg/image/PlaneQuantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ComparisonFigures.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageComparison.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/TiffFile.h"
#include "tests/image/ImageFixtures.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using smat::test::ownFolder;
using test::inputErrorOf;
using testing::AllOf;
using testing::HasSubstr;

/// An image of radiance 2 with a plane of another quantity in front, of 300 and up.
RadianceImage shown(const std::string& channel, const std::string& unit, float offset = 0.0F) {
    RadianceImage image(4, 3, channel, unit);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        image.primary().values[i] = 300.0F + offset + static_cast<float>(i);
    }
    image.attributes["sensor.horizontal_field_of_view_deg"] = "2";
    image.attributes["range_m"] = "1000";
    image.attributes["background_W_m2_sr"] = "0.5";
    if (channel != "L") {
        auto& radiance = image.channel("L", "W m-2 sr-1").values;
        radiance.assign(radiance.size(), 2.0F);
    }
    return image;
}

struct Shown {
    const char *channel, *unit, *quantity;
};
constexpr Shown allShown[] = {{"L", "W m-2 sr-1", "radiance"},
                              {"T_apparent", "K", "temperature"},
                              {"E", "W m-2", "irradiance"},
                              {"counts", "", "counts"}};

} // namespace

TEST(PlaneQuantity, IsByUnitNameOrAttributesOfTheImage) {
    const struct {
        const char* name;
        const char *channel, *unit;
        std::map<std::string, std::string> attributes;
        PlaneQuantity is;
    } rows[] = {{"our radiance", "L", "W m-2 sr-1", {}, {"radiance", "W m-2 sr-1"}},
                {"our apparent temperature", "T_apparent", "K", {}, {"temperature", "K"}},
                {"our counts", "counts", "", {}, {"counts", ""}},
                {"a unit of nobody", "Y", "furlong", {{"quantity", "radiance"}}, {"", "furlong"}},
                {"nothing", "Y", "", {}, {"", ""}},
                {"ours by its setting",
                 "Y",
                 "",
                 {{"image.quantity", "apparent-temperature"}},
                 {"temperature", "K"}},
                {"words and unit",
                 "Y",
                 "",
                 {{"quantity", "Surface Temperature"}, {"units", "degC"}},
                 {"temperature", "degC"}},
                {"words alone", "L", "", {{"quantity", "irradiance"}}, {"irradiance", "W m-2"}},
                {"spectral",
                 "L",
                 "",
                 {{"quantity", "spectral radiance"}},
                 {"spectral radiance", "W m-2 sr-1 um-1"}},
                {"unit alone", "L", "", {{"unit", "K"}}, {"temperature", "K"}},
                {"digital numbers", "Y", "", {{"quantity", "DN"}}, {"counts", ""}},
                {"the unit of the plane wins",
                 "L",
                 "W m-2",
                 {{"quantity", "counts"}},
                 {"irradiance", "W m-2"}}};
    for (const auto& row : rows) {
        RadianceImage image(1, 1, row.channel, row.unit);
        image.attributes = row.attributes;
        EXPECT_EQ(quantityOf(image, image.primary()).name, row.is.name) << row.name;
        EXPECT_EQ(quantityOf(image, image.primary()).unit, row.is.unit) << row.name;
    }
    RadianceImage several(1, 1, "Y", "");
    several.attributes["quantity"] = "temperature";
    EXPECT_EQ(quantityOf(several, several.channel("alpha")), PlaneQuantity())
        << "attributes are of the plane that is shown";
}

TEST(PlaneQuantity, TwoFilesOfOneQuantityAreComparedInIt) {
    for (const Shown& one : allShown) {
        for (const std::string extension : {"exr", "tif"}) {
            SCOPED_TRACE(one.channel + extension);
            const auto fileA = ownFolder() / ("a." + extension),
                       fileB = ownFolder() / ("b." + extension);
            const RadianceImage a = shown(one.channel, one.unit, 0.5F),
                                b = shown(one.channel, one.unit);
            extension == "exr" ? writeExr(a, fileA) : writeTiff(a, fileA);
            extension == "exr" ? writeExr(b, fileB) : writeTiff(b, fileB);
            const Comparison compared = compareImages(readImageFile(fileA), readImageFile(fileB));
            EXPECT_EQ(compared.meanError, 0.5);
            EXPECT_EQ(compared.channelA, one.channel);
            EXPECT_EQ(compared.quantity, one.quantity);
            EXPECT_EQ(compared.unit, one.unit);
            EXPECT_EQ(compared.totalIsIntensity, one.quantity == std::string("radiance"));
        }
    }
}

TEST(PlaneQuantity, TwoQuantitiesAreRefusedByNameUnlessChannelsAreNamed) {
    for (const Shown& one : allShown) {
        for (const Shown& other : allShown) {
            if (one.channel == other.channel) {
                continue;
            }
            SCOPED_TRACE(std::string(one.channel) + " with " + other.channel);
            const RadianceImage a = shown(one.channel, one.unit),
                                b = shown(other.channel, other.unit);
            EXPECT_THAT(
                inputErrorOf([&] { compareImages(a, b, {.nameA = "a.exr", .nameB = "b.exr"}); }),
                AllOf(HasSubstr("b.exr"), HasSubstr(other.quantity), HasSubstr(one.quantity),
                      HasSubstr("a.exr")));
            const Comparison asked =
                compareImages(a, b, {.channelA = one.channel, .channelB = other.channel});
            EXPECT_EQ(asked.quantity, "");
            EXPECT_EQ(asked.channelB, other.channel);
            const Comparison radiance = compareImages(a, b, {.channel = "L"});
            EXPECT_EQ(radiance.quantity, "radiance");
        }
    }
}

TEST(PlaneQuantity, AttributesOfAnotherProgramGiveUnitAndQuantityOfItsY) {
    RadianceImage a = shown("Y", ""), b = shown("Y", "", 1.0F);
    a.channels.resize(1);
    b.channels.resize(1);
    for (RadianceImage* image : {&a, &b}) {
        image->attributes["quantity"] = "brightness temperature";
        image->attributes["units"] = "K";
    }
    writeExr(a, ownFolder() / "a.exr");
    writeExr(b, ownFolder() / "b.exr");
    const RadianceImage readA = readImageFile(ownFolder() / "a.exr"),
                        readB = readImageFile(ownFolder() / "b.exr");
    const Comparison compared = compareImages(readA, readB);
    EXPECT_EQ(compared.quantity, "temperature");
    EXPECT_EQ(compared.unit, "K");
    EXPECT_FALSE(compared.totalIsIntensity);
    EXPECT_EQ(differenceImage(readA, readB, compared, {}).primary().unit, "K");
    EXPECT_THAT(inputErrorOf([&] { compareImages(readA, shown("L", "W m-2 sr-1")); }),
                AllOf(HasSubstr("radiance (channel L)"), HasSubstr("temperature as in channel Y")));
    // Nothing is known of a plain matrix, which is compared as before.
    EXPECT_NO_THROW(compareImages(readA, shown("L", "")));
}

} // namespace irsg
