#include "irsg/radiance/SpecularEnvironmentGrid.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Angles from the horizon, degrees; the last row is straight up or down.
constexpr double skyRows_deg[] = {0.02, 1.0, 3.0, 8.0, 20.0, 45.0};
constexpr double groundRows_deg[] = {0.02, 0.5, 2.5, 10.0, 35.0};
/// Angles from the sun's azimuth, degrees.
constexpr double columns_deg[] = {0.0, 15.0, 45.0, 90.0, 180.0};
constexpr double bend_rad = 0.02;

double skyCoordinate(double above_rad) {
    return std::log1p(std::max(above_rad, 0.0) / bend_rad);
}
double groundCoordinate(double below_rad) {
    return std::log1p(std::sqrt(std::max(below_rad, 0.0) / bend_rad));
}

} // namespace

SpecularEnvironmentGrid::SpecularEnvironmentGrid(double horizon_rad, bool byAzimuth)
    : horizon_rad_(horizon_rad), columns_(byAzimuth ? std::size(columns_deg) : 1) {
    const auto addRow = [&](double elevation_rad) {
        for (std::size_t c = 0; c < columns_; ++c)
            places_.push_back({elevation_rad, radians(columns_deg[c])});
    };
    for (const double row_deg : skyRows_deg) {
        sky_.push_back(skyCoordinate(radians(row_deg)));
        addRow(horizon_rad + radians(row_deg));
    }
    sky_.push_back(skyCoordinate(0.5 * pi - horizon_rad));
    addRow(0.5 * pi);
    for (const double row_deg : groundRows_deg) {
        ground_.push_back(groundCoordinate(radians(row_deg)));
        addRow(horizon_rad - radians(row_deg));
    }
    ground_.push_back(groundCoordinate(0.5 * pi + horizon_rad));
    addRow(-0.5 * pi);
}

std::array<std::pair<std::size_t, double>, 4>
SpecularEnvironmentGrid::about(double elevation_rad, double fromSun_rad) const {
    const double above_rad = elevation_rad - horizon_rad_;
    const Bracket row = above_rad >= 0.0 ? bracket(sky_, skyCoordinate(above_rad))
                                         : bracket(ground_, groundCoordinate(-above_rad));
    const double down = row.fraction;
    const std::size_t first = (above_rad >= 0.0 ? row.below : sky_.size() + row.below) * columns_;
    const auto [column, next, across] =
        bracket(std::span(columns_deg).first(columns_), fromSun_rad, Beyond::clamp, radians);
    return {{{first + column, (1.0 - down) * (1.0 - across)},
             {first + next, (1.0 - down) * across},
             {first + columns_ + column, down * (1.0 - across)},
             {first + columns_ + next, down * across}}};
}

} // namespace irsg
