#include "gui/plot/DirectionLookup.h"

#include <algorithm>
#include <cmath>

#include "irsg/geometry/view/Pose.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {

namespace {

constexpr int columns = 720, rows = 361; // of half a degree, poles included
constexpr double step_deg = 0.5;

/// The middles between values, and as far beyond the first and the last.
std::vector<double> endsOf(const std::vector<double>& values, double alone) {
    if (values.size() == 1)
        return {values[0] - alone, values[0] + alone};
    std::vector<double> ends{values[0] - 0.5 * (values[1] - values[0])};
    for (std::size_t i = 1; i < values.size(); ++i)
        ends.push_back(0.5 * (values[i - 1] + values[i]));
    ends.push_back(values.back() + 0.5 * (values.back() - values[values.size() - 2]));
    return ends;
}

irsg::Vec3 towards(double azimuth_deg, double elevation_deg) {
    return irsg::direction(irsg::radians(azimuth_deg), irsg::radians(elevation_deg));
}

} // namespace

DirectionLookup::DirectionLookup(const SignatureTable& table) : table_(table) {
    if (table.isGrid()) {
        azimuthEnds_ = endsOf(table.azimuths_deg(), 180.0);
        elevationEnds_ = endsOf(table.elevations_deg(), 90.0);
    } else {
        spread();
    }
}

int DirectionLookup::nearest(double azimuth_deg, double elevation_deg) const {
    if (!ofPlace_.empty()) {
        const int row = std::clamp(static_cast<int>(std::lround((elevation_deg + 90.0) / step_deg)),
                                   0, rows - 1);
        const long column = std::lround(azimuth_deg / step_deg);
        return ofPlace_[static_cast<std::size_t>(row * columns) +
                        static_cast<std::size_t>(((column % columns) + columns) % columns)];
    }
    return nearestOfGrid(azimuth_deg, elevation_deg);
}

int DirectionLookup::nearestOfGrid(double azimuth_deg, double elevation_deg) const {
    if (elevation_deg < elevationEnds_.front() || elevation_deg > elevationEnds_.back())
        return nothing;
    // Whole turns away until it is in the first turn of the cells.
    const double first = azimuthEnds_.front();
    const double turned = azimuth_deg - 360.0 * std::floor((azimuth_deg - first) / 360.0);
    if (turned > azimuthEnds_.back())
        return nothing;
    const auto cell = [](const std::vector<double>& ends, double value) {
        const auto above = std::ranges::upper_bound(ends, value);
        return std::min(static_cast<std::size_t>(above - ends.begin()), ends.size() - 1) - 1;
    };
    return static_cast<int>(
        table_.direction(cell(elevationEnds_, elevation_deg), cell(azimuthEnds_, turned)));
}

void DirectionLookup::spread() {
    const auto& directions = table_.directions();
    ofPlace_.assign(static_cast<std::size_t>(columns) * rows, nothing);
    std::vector<double> closest(ofPlace_.size(), -2.0);
    // On an even sphere the farthest place from all is 1.16 times a cell's radius away.
    const double reach_deg = std::clamp(
        irsg::degrees(1.3 * std::sqrt(4.0 / static_cast<double>(directions.size()))), 1.5, 90.0);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto& [azimuth_deg, elevation_deg] = directions[i];
        const irsg::Vec3 own = towards(azimuth_deg, elevation_deg);
        const int low = std::max(
            0, static_cast<int>(std::floor((elevation_deg - reach_deg + 90.0) / step_deg)));
        const int high = std::min(
            rows - 1, static_cast<int>(std::ceil((elevation_deg + reach_deg + 90.0) / step_deg)));
        for (int row = low; row <= high; ++row) {
            const double at_deg = row * step_deg - 90.0;
            const double widest = std::max(
                std::cos(irsg::radians(std::min(std::abs(at_deg) + reach_deg, 90.0))), 1e-3);
            const int half =
                std::min(columns / 2, static_cast<int>(std::ceil(reach_deg / widest / step_deg)));
            const long middle = std::lround(azimuth_deg / step_deg);
            for (long column = middle - half; column < middle + half; ++column) {
                const auto place =
                    static_cast<std::size_t>(row * columns) +
                    static_cast<std::size_t>(((column % columns) + columns) % columns);
                const double cosine =
                    irsg::dot(own, towards(static_cast<double>(column) * step_deg, at_deg));
                if (cosine > closest[place] && cosine >= std::cos(irsg::radians(reach_deg))) {
                    closest[place] = cosine;
                    ofPlace_[place] = static_cast<std::int32_t>(i);
                }
            }
        }
    }
}

} // namespace smat::gui
