#include "irsg/radiometry/Units.h"

#include <gtest/gtest.h>

using namespace irsg;

TEST(Units, DegreesAndRadiansAreInverse) {
    EXPECT_DOUBLE_EQ(radians(180.0), pi);
    EXPECT_DOUBLE_EQ(degrees(pi / 2.0), 90.0);
    EXPECT_DOUBLE_EQ(degrees(radians(12.345)), 12.345);
}

TEST(Units, CelsiusStartsAt27315Kelvin) {
    EXPECT_DOUBLE_EQ(kelvinFromCelsius(20.0), 293.15);
    EXPECT_DOUBLE_EQ(celsiusFromKelvin(0.0), -273.15);
}

TEST(Units, WavenumbersAndWavelengthsAreReciprocal) {
    EXPECT_DOUBLE_EQ(wavelengthFromWavenumber_um(2500.0), 4.0);
    EXPECT_DOUBLE_EQ(wavenumberFromWavelength_per_cm(4.0), 2500.0);
}

TEST(Units, DensitiesChangeByTheJacobian) {
    // 1900 cm-1: 361 times as much per um as per cm-1.
    EXPECT_DOUBLE_EQ(perMicrometreFromPerWavenumber(1.0, 1900.0), 361.0);
    EXPECT_DOUBLE_EQ(perWavenumberFromPerMicrometre(361.0, 1e4 / 1900.0), 1.0);
}
