#include "irsg/image/ApparentTemperature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::infinity;
using test::nanValue;

const Band bands[] = {Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0), Band::topHat(1.9, 2.9),
                      Band::topHat(3.9, 3.9001), Band::topHat(0.2, 40.0)};

TEST(ApparentTemperature, OfABlackBodyIsItsTemperature) {
    for (const Band& band : bands) {
        const ApparentTemperatureTable table(band, bandRadiance_W_m2_sr(band, 150.0),
                                             bandRadiance_W_m2_sr(band, 6000.0));
        for (double temperature_K = 150.0; temperature_K < 6000.0; temperature_K *= 1.0137) {
            EXPECT_NEAR(table.at(bandRadiance_W_m2_sr(band, temperature_K)), temperature_K,
                        1e-4 * std::max(1.0, temperature_K / 5000.0))
                << band.name();
        }
    }
}

TEST(ApparentTemperature, AgreesWithTheDirectSolutionOverAllThatFloatsHold) {
    for (const Band& band : bands) {
        const double low = 1e-45, high = bandRadiance_W_m2_sr(band, 9e5);
        const ApparentTemperatureTable table(band, low, high);
        for (double radiance = low; radiance < high; radiance *= 7.3) {
            const double exact_K = apparentTemperature_K(band, radiance).value();
            EXPECT_NEAR(table.at(radiance), exact_K, 1e-4 * std::max(1.0, exact_K / 5000.0))
                << band.name() << " " << radiance;
        }
    }
}

TEST(ApparentTemperature, OfOneRadianceAloneIsRight) {
    const double radiance = bandRadiance_W_m2_sr(bands[0], 300.0);
    EXPECT_NEAR(ApparentTemperatureTable(bands[0], radiance, radiance).at(radiance), 300.0, 1e-6);
}

TEST(ApparentTemperature, OutsideTheTableIsSolvedForDirectly) {
    const ApparentTemperatureTable table(bands[0], 1.0, 2.0);
    for (const double temperature_K : {120.0, 900.0}) {
        EXPECT_NEAR(table.at(bandRadiance_W_m2_sr(bands[0], temperature_K)), temperature_K, 1e-5);
    }
}

TEST(ApparentTemperature, HasNoValueWhereNoBlackBodyIsSo) {
    const ApparentTemperatureTable table(bands[0], 1.0, 2.0);
    for (const double radiance :
         {0.0, -1.0, static_cast<double>(nanValue), static_cast<double>(infinity), 1e30}) {
        EXPECT_TRUE(std::isnan(table.at(radiance))) << radiance;
    }
}

TEST(ApparentTemperature, RefusesRangesThatAreNone) {
    EXPECT_THROW(ApparentTemperatureTable(bands[0], 0.0, 1.0), LogicError);
    EXPECT_THROW(ApparentTemperatureTable(bands[0], 2.0, 1.0), LogicError);
    EXPECT_THROW(ApparentTemperatureTable(bands[0], 1.0, infinity), LogicError);
    EXPECT_THROW(ApparentTemperatureTable(bands[0], nanValue, 1.0), LogicError);
}

TEST(ApparentTemperature, IsAddedToAnImageWithTheCountOfItsHoles) {
    const Band& band = bands[1];
    RadianceImage image(3, 2);
    image.primary().values = {static_cast<float>(bandRadiance_W_m2_sr(band, 300.0)),
                              0.0F,
                              -1.0F,
                              nanValue,
                              infinity,
                              1e30F};
    EXPECT_EQ(addApparentTemperature(image, band), 5U);
    const ImageChannel* plane = image.find("T_apparent");
    ASSERT_NE(plane, nullptr);
    EXPECT_EQ(plane->unit, "K");
    EXPECT_NEAR(plane->values[0], 300.0F, 1e-4F);
    for (std::size_t i = 1; i < 6; ++i) {
        EXPECT_TRUE(std::isnan(plane->values[i])) << i;
    }
    EXPECT_EQ(image.attributes.at("apparentTemperature.pixelsWithoutValue"), "5");
    EXPECT_EQ(image.attributes.at("apparentTemperature.band"), band.name());
    EXPECT_EQ(image.primary().name, "L");

    // A second call renews the plane for another band.
    image.primary().values.assign(6, 1.0F);
    EXPECT_EQ(addApparentTemperature(image, bands[0]), 0U);
    EXPECT_EQ(image.channels.size(), 2U);
    EXPECT_NEAR(image.find("T_apparent")->values[5], *apparentTemperature_K(bands[0], 1.0), 2e-4);
}

TEST(ApparentTemperature, OfADarkImageIsNothing) {
    RadianceImage image(2, 1);
    EXPECT_EQ(addApparentTemperature(image, bands[0]), 2U);
    RadianceImage empty;
    EXPECT_THROW(addApparentTemperature(empty, bands[0]), LogicError);
    RadianceImage temperature(1, 1, "T_apparent", "K");
    EXPECT_THROW(addApparentTemperature(temperature, bands[0]), LogicError);
}

} // namespace
} // namespace irsg
