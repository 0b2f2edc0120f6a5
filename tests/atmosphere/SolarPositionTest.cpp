#include "irsg/atmosphere/SolarPosition.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;

// The example of NREL/TP-560-34302, table A5.1: Golden, 17 October 2003, 12:30:30 of a zone 7 hours
// west, 1830.14 m, delta T of 67 s.
TEST(SolarPosition, IsThatOfThePublishedExample) {
    const UniversalTime time = UniversalTime::fromText("2003-10-17", "19:30:30", "");
    EXPECT_NEAR(time.julianDay(), 2452930.312847, 1e-6);
    const Geographic golden{radians(39.742476), radians(-105.1786), 1830.14};
    const SunPosition sun = sunPosition(time, golden, 67.0);
    EXPECT_NEAR(degrees(sun.azimuth_rad), 194.340241, 1e-6);
    EXPECT_NEAR(degrees(sun.elevation_rad), 39.872046, 1e-6);
    EXPECT_NEAR(sun.distance_au, 0.9965422974, 1e-10);
    // With the delta T of the polynomials, and without the height of the observer.
    const SunPosition plain = sunPosition(time, {golden.latitude_rad, golden.longitude_rad});
    EXPECT_NEAR(degrees(plain.azimuth_rad), 194.340241, 1e-3);
    EXPECT_NEAR(degrees(plain.elevation_rad), 39.872046, 1e-3);
}

// J. Meeus, Astronomical Algorithms, example 25.b: the distance on 13 October 1992 at 0 h dynamical
// time.
TEST(SolarPosition, HasTheDistanceOfMeeusExample) {
    EXPECT_NEAR(sunPosition({1992, 10, 13, 0.0}, {}, 0.0).distance_au, 0.99760775, 1e-7);
}

TEST(SolarPosition, ComesNearestInJanuaryAndIsFarthestInJuly) {
    EXPECT_NEAR(sunDistance_au(4), 0.98333, 5e-5);
    EXPECT_NEAR(sunDistance_au(184), 1.01665, 5e-5);
    EXPECT_NEAR(sunDistance_au(366), sunDistance_au(1), 1e-4);
    const SunPosition near{0.0, 0.5, sunDistance_au(4)}, far{0.0, 0.5, sunDistance_au(184)};
    EXPECT_NEAR(near.strength() / far.strength(), 1.069, 1e-3);
}

// From one place at one moment the sun stands as high as from the mirrored place half a turn around
// the year later, within the eccentricity and the equation of time; and noon is in the south.
TEST(SolarPosition, StandsInTheSouthAtNoonAndInTheNorthBelowTheEquator) {
    const SunPosition north = sunPosition({2024, 3, 20, 12.12}, {radians(50.0), 0.0});
    EXPECT_NEAR(degrees(north.azimuth_rad), 180.0, 1.0);
    EXPECT_NEAR(degrees(north.elevation_rad), 40.0, 0.3);
    const SunPosition south = sunPosition({2024, 3, 20, 12.12}, {radians(-50.0), 0.0});
    EXPECT_NEAR(std::remainder(degrees(south.azimuth_rad), 360.0), 0.0, 1.0);
    const SunPosition morning = sunPosition({2024, 3, 20, 6.12}, {0.0, 0.0});
    EXPECT_NEAR(degrees(morning.azimuth_rad), 90.0, 0.3);
    EXPECT_NEAR(degrees(morning.elevation_rad), 0.0, 0.3);
    const SunPosition polar = sunPosition({2024, 12, 21, 12.0}, {0.5 * pi, 0.0});
    EXPECT_NEAR(degrees(polar.elevation_rad), -23.44, 0.01);
}

TEST(SolarPosition, KnowsTheDayOfTheYear) {
    EXPECT_EQ(UniversalTime::fromText("2024-12-31", "23:59:59.9", "").dayOfYear(), 366);
    EXPECT_EQ(UniversalTime::fromText("2023-01-01", "00:00", "").dayOfYear(), 1);
    EXPECT_EQ(UniversalTime::fromText("2023-03-01", "12:00", "").dayOfYear(), 60);
}

TEST(SolarPosition, RefusesWhatIsNoMoment) {
    struct Row {
        const char *date, *utc, *position;
    };
    for (const Row& row : {Row{"2003-02-29", "12:00", "date"},
                           {"2003-13-01", "12:00", "date"},
                           {"2003-00-10", "12:00", "date"},
                           {"17.10.2003", "12:00", "date"},
                           {"2003-10", "12:00", "date"},
                           {"2003-10-17-1", "12:00", "date"},
                           {"", "12:00", "date"},
                           {"1960-12-31", "12:00", "date"},
                           {"2101-01-01", "12:00", "date"},
                           {"2003--1-17", "12:00", "date"},
                           {"2003-10-17", "24:00", "utc"},
                           {"2003-10-17", "12:60", "utc"},
                           {"2003-10-17", "12:00:60", "utc"},
                           {"2003-10-17", "12", "utc"},
                           {"2003-10-17", "", "utc"},
                           {"2003-10-17", "12:00Z", "utc"},
                           {"2003-10-17", "12:00:nan", "utc"},
                           {"2003-10-17", "-1:00", "utc"},
                           {"2003-10-17", "12:00:00:00", "utc"}}) {
        try {
            (void)UniversalTime::fromText(row.date, row.utc, "moment");
            ADD_FAILURE() << row.date << " " << row.utc;
        } catch (const InputError& error) {
            EXPECT_EQ(error.diagnostics().front().position, row.position)
                << row.date << " " << row.utc;
            EXPECT_EQ(error.diagnostics().front().file, "moment");
        }
    }
}
