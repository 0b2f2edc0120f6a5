#pragma once

#include <string>

#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace irsg {

/// A moment of universal time.
struct UniversalTime {
    int year = 2000, month = 1, day = 1;
    double hour = 0.0; ///< 0 to below 24

    /// From "2003-10-17" and "19:30" or "19:30:30" (seconds may have a fraction). InputError that
    /// names `file`, the position ("date" or "utc"), the text and what was expected, for text that
    /// is none, days that no calendar has and years before 1961 or after 2100.
    static UniversalTime fromText(const std::string& date, const std::string& utc,
                                  const std::string& file);

    int dayOfYear() const; ///< 1 to 366
    /// Days since noon of 1 January 4713 BC, universal time.
    double julianDay() const;
    /// Terrestrial less universal time, s: the polynomials of F. Espenak and J. Meeus (Five
    /// Millennium Canon of Solar Eclipses, NASA/TP-2006-214141), within 5 s until 2030.
    double deltaT_s() const;
};

/// Where on the earth.
struct Geographic {
    double latitude_rad = 0.0;  ///< north positive
    double longitude_rad = 0.0; ///< east positive
    double altitude_m = 0.0;
};

/// The sun by NREL's Solar Position Algorithm (I. Reda and A. Andreas, Solar Position Algorithm for
/// Solar Radiation Applications, NREL/TP-560-34302, revised 2008): topocentric azimuth, true
/// elevation without refraction, distance. Stated uncertainty 0.0003 degrees. `deltaT_s` is that of
/// the time unless it is given.
SunPosition sunPosition(const UniversalTime& time, const Geographic& place);
SunPosition sunPosition(const UniversalTime& time, const Geographic& place, double deltaT_s);

/// The distance of the sun at noon of a day of a year without a leap day, 1 to 365 (366 is that of
/// the next 1 January): of 2025 by the same algorithm. From year to year it differs by up to 2e-4.
double sunDistance_au(int dayOfYear);

} // namespace irsg
