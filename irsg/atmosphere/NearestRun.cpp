#include "irsg/atmosphere/NearestRun.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "irsg/atmosphere/AtmosphereDescription.h"
#include "irsg/atmosphere/import/Interpolation.h"

namespace irsg {

namespace {

constexpr const char* beginning = " (nearest run at most ";

std::optional<RunDistance> distanceIn(const std::string& line) {
    const std::size_t at = line.find(beginning);
    RunDistance found;
    if (at == std::string::npos ||
        std::sscanf(line.c_str() + at, " (nearest run at most %lf m in altitude, %lf %*s",
                    &found.altitude_m, &found.range_m) != 2)
        return std::nullopt;
    if (line.find("deg in elevation", at) != std::string::npos)
        found.elevation_deg = std::exchange(found.range_m, 0.0);
    return found;
}

} // namespace

std::string nearestRunText(const RunDistance& distance) {
    // Millimetres and thousandths of a degree: what is nearer is at the run.
    const auto rounded = [](double value) { return std::round(1e3 * value) / 1e3; };
    return beginning + metresText(rounded(distance.altitude_m)) + " m in altitude, " +
           (distance.elevation_deg > 0.0
                ? general(rounded(distance.elevation_deg), 6) + " deg in elevation"
                : metresText(rounded(distance.range_m)) + " m in range") +
           " away)";
}

std::string withoutNearestRun(std::string line) {
    line.resize(std::min(line.find(beginning), line.size()));
    return line;
}

void addProvider(std::vector<std::string>& lines, std::string line) {
    const auto distance = distanceIn(line);
    const auto place = std::ranges::find_if(lines, [&](const std::string& other) {
        return other == line || (distance && distanceIn(other) &&
                                 withoutNearestRun(other) == withoutNearestRun(line));
    });
    if (place == lines.end()) {
        lines.push_back(std::move(line));
    } else if (distance && *place != line) {
        const RunDistance other = *distanceIn(*place);
        *place = withoutNearestRun(std::move(line)) +
                 nearestRunText({std::max(distance->altitude_m, other.altitude_m),
                                 std::max(distance->range_m, other.range_m),
                                 std::max(distance->elevation_deg, other.elevation_deg)});
    }
}

void addProvider(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    for (const std::string& line : more)
        addProvider(lines, line);
}

} // namespace irsg
