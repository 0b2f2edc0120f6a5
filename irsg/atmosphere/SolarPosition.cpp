#include "irsg/atmosphere/SolarPosition.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "irsg/atmosphere/SolarPositionTerms.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr int firstYear = 1961, lastYear = 2100;
constexpr double epoch2000_day = 2451545.0;

double turned_deg(double angle_deg) {
    const double turned = std::fmod(angle_deg, 360.0);
    return turned < 0.0 ? turned + 360.0 : turned;
}

double polynomial(double x, std::initializer_list<double> coefficients) {
    double sum = 0.0;
    for (auto c = std::rbegin(coefficients); c != std::rend(coefficients); ++c)
        sum = sum * x + *c;
    return sum;
}

/// Section 3.2 of the report: sum over powers of the millennium.
double periodic(const spa::Series& series, double millennia) {
    double sum = 0.0, power = 1.0;
    for (const auto& terms : series) {
        for (const spa::Term& term : terms)
            sum += power * term.a * std::cos(term.b + term.c * millennia);
        power *= millennia;
    }
    return 1e-8 * sum;
}

struct NutationAngles {
    double longitude_deg = 0.0, obliquity_deg = 0.0;
};

/// Section 3.4.
NutationAngles nutationAt(double centuries) {
    const double x[] = {polynomial(centuries, {297.85036, 445267.111480, -0.0019142, 1.0 / 189474}),
                        polynomial(centuries, {357.52772, 35999.050340, -0.0001603, -1.0 / 300000}),
                        polynomial(centuries, {134.96298, 477198.867398, 0.0086972, 1.0 / 56250}),
                        polynomial(centuries, {93.27191, 483202.017538, -0.0036825, 1.0 / 327270}),
                        polynomial(centuries, {125.04452, -1934.136261, 0.0020708, 1.0 / 450000})};
    constexpr double unitsPerDegree = 36e6;
    NutationAngles sum;
    for (const spa::Nutation& term : spa::nutation) {
        double angle_deg = 0.0;
        for (std::size_t i = 0; i < term.y.size(); ++i)
            angle_deg += term.y[i] * x[i];
        const double angle_rad = radians(angle_deg);
        sum.longitude_deg += (term.a + term.b * centuries) * std::sin(angle_rad) / unitsPerDegree;
        sum.obliquity_deg += (term.c + term.d * centuries) * std::cos(angle_rad) / unitsPerDegree;
    }
    return sum;
}

/// Mean obliquity of the ecliptic, section 3.5, in decamillennia from 2000.
double meanObliquity_deg(double u) {
    return polynomial(u, {84381.448, -4680.93, -1.55, 1999.25, -51.38, -249.67, -39.05, 7.12, 27.87,
                          5.79, 2.45}) /
           3600.0;
}

/// The whole of a text as a number.
template <typename Number>
std::optional<Number> numberIn(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty() ||
        text.front() == '-')
        return std::nullopt;
    return number;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

} // namespace

UniversalTime UniversalTime::fromText(const std::string& date, const std::string& utc,
                                      const std::string& file) {
    const auto dateParts = split(date, '-');
    const auto whole = [&](std::size_t i) {
        return dateParts.size() == 3 ? numberIn<int>(dateParts[i]) : std::nullopt;
    };
    const auto year = whole(0), month = whole(1), day = whole(2);
    const auto calendar = [&] {
        return std::chrono::year_month_day{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    };
    if (!year || !month || !day || *year < firstYear || *year > lastYear || !calendar().ok())
        throw InputError(
            {file, "date", date, "a day of the calendar as 2003-10-17, of the years 1961 to 2100"});

    const auto timeParts = split(utc, ':');
    const auto hours = numberIn<int>(timeParts[0]);
    const auto minutes = timeParts.size() > 1 ? numberIn<int>(timeParts[1]) : std::nullopt;
    const auto seconds = timeParts.size() > 2 ? numberIn<double>(timeParts[2]) : 0.0;
    if (timeParts.size() > 3 || !hours || !minutes || !seconds || *hours > 23 || *minutes > 59 ||
        !(*seconds < 60.0))
        throw InputError({file, "utc", utc, "universal time as 19:30 or 19:30:30, below 24:00"});
    return {*year, *month, *day, *hours + *minutes / 60.0 + *seconds / 3600.0};
}

int UniversalTime::dayOfYear() const {
    const UniversalTime newYear{year, 1, 1, hour};
    return 1 + static_cast<int>(std::lround(julianDay() - newYear.julianDay()));
}

double UniversalTime::julianDay() const {
    const std::chrono::sys_days midnight = std::chrono::year_month_day{
        std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
        std::chrono::day(static_cast<unsigned>(day))};
    constexpr double unixEpoch_day = 2440587.5;
    return unixEpoch_day + static_cast<double>(midnight.time_since_epoch().count()) + hour / 24.0;
}

double UniversalTime::deltaT_s() const {
    const double when = year + (month - 0.5) / 12.0;
    const double t = when - 2000.0;
    if (when < 1986.0) {
        const double u = when - 1975.0;
        return polynomial(u, {45.45, 1.067, -1.0 / 260.0, -1.0 / 718.0});
    }
    if (when < 2005.0)
        return polynomial(t, {63.86, 0.3345, -0.060374, 0.0017275, 0.000651814, 0.00002373599});
    if (when < 2050.0)
        return polynomial(t, {62.92, 0.32217, 0.005589});
    const double centuries = (when - 1820.0) / 100.0;
    return -20.0 + 32.0 * centuries * centuries - 0.5628 * (2150.0 - when);
}

SunPosition sunPosition(const UniversalTime& time, const Geographic& place) {
    return sunPosition(time, place, time.deltaT_s());
}

SunPosition sunPosition(const UniversalTime& time, const Geographic& place, double deltaT_s) {
    // Time: Julian days, and ephemeris centuries and millennia (3.1).
    const double days = time.julianDay() - epoch2000_day;
    const double ephemerisCenturies = (days + deltaT_s / 86400.0) / 36525.0;
    const double millennia = 0.1 * ephemerisCenturies;

    // The sun as the middle of the earth sees it (3.2 to 3.8), turned by nutation and aberration.
    const double distance_au = periodic(spa::radius, millennia);
    const double latitude_deg = -degrees(periodic(spa::latitude, millennia));
    const NutationAngles nutation = nutationAt(ephemerisCenturies);
    const double aberration_deg = -20.4898 / (3600.0 * distance_au);
    const double longitude_deg = degrees(periodic(spa::longitude, millennia)) + 180.0 +
                                 nutation.longitude_deg + aberration_deg;
    const double obliquity_rad =
        radians(meanObliquity_deg(0.1 * millennia) + nutation.obliquity_deg);

    // On the celestial sphere (3.9 to 3.11).
    const double lambda = radians(turned_deg(longitude_deg)), beta = radians(latitude_deg);
    const double rightAscension_rad = std::atan2(std::sin(lambda) * std::cos(obliquity_rad) -
                                                     std::tan(beta) * std::sin(obliquity_rad),
                                                 std::cos(lambda));
    const double declination_rad =
        std::asin(std::sin(beta) * std::cos(obliquity_rad) +
                  std::cos(beta) * std::sin(obliquity_rad) * std::sin(lambda));
    const double centuries = days / 36525.0;
    const double siderealTime_deg = 280.46061837 + 360.98564736629 * days +
                                    centuries * centuries * (0.000387933 - centuries / 38710000.0) +
                                    nutation.longitude_deg * std::cos(obliquity_rad);
    const double hour_rad = radians(
        turned_deg(siderealTime_deg + degrees(place.longitude_rad) - degrees(rightAscension_rad)));

    // As the observer sees it, who stands beside the middle of the earth (3.12, 3.13).
    const double parallax_rad = radians(8.794 / (3600.0 * distance_au));
    const double u = std::atan(0.99664719 * std::tan(place.latitude_rad));
    const double x = std::cos(u) + place.altitude_m / 6378140.0 * std::cos(place.latitude_rad);
    const double y =
        0.99664719 * std::sin(u) + place.altitude_m / 6378140.0 * std::sin(place.latitude_rad);
    const double across =
        std::cos(declination_rad) - x * std::sin(parallax_rad) * std::cos(hour_rad);
    const double shift_rad = std::atan2(-x * std::sin(parallax_rad) * std::sin(hour_rad), across);
    const double topocentricDeclination_rad = std::atan2(
        (std::sin(declination_rad) - y * std::sin(parallax_rad)) * std::cos(shift_rad), across);
    const double topocentricHour_rad = hour_rad - shift_rad;

    // Above the horizontal plane and around it, from the north (3.14, 3.15).
    const double elevation_rad =
        std::asin(std::sin(place.latitude_rad) * std::sin(topocentricDeclination_rad) +
                  std::cos(place.latitude_rad) * std::cos(topocentricDeclination_rad) *
                      std::cos(topocentricHour_rad));
    const double azimuth_deg =
        180.0 + degrees(std::atan2(std::sin(topocentricHour_rad),
                                   std::cos(topocentricHour_rad) * std::sin(place.latitude_rad) -
                                       std::tan(topocentricDeclination_rad) *
                                           std::cos(place.latitude_rad)));
    return {radians(turned_deg(azimuth_deg)), elevation_rad, distance_au};
}

double sunDistance_au(int dayOfYear) {
    UniversalTime noon{2025, 1, 1, 12.0};
    noon.hour += 24.0 * (dayOfYear - 1);
    return sunPosition(noon, {}).distance_au;
}

} // namespace irsg
