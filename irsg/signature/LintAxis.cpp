#include "irsg/signature/LintAxis.h"

#include <algorithm>
#include <numeric>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr SpectralRange infrared{0.1, 200.0};
/// What infrared work is done in: decides between readings that are both possible.
constexpr SpectralRange usual{0.7, 30.0};

SpectralRange rangeOf(const AxisReading& reading, double first, double last) {
    const double a_um = reading.wavelength_um(first);
    const double b_um = reading.wavelength_um(last);
    return {std::min(a_um, b_um), std::max(a_um, b_um)};
}

bool overlapsAny(const SpectralRange& range, const std::vector<SpectralRange>& bands) {
    return std::ranges::any_of(bands, [&](const SpectralRange& band) {
        return range.min_um < band.max_um && band.min_um < range.max_um;
    });
}

} // namespace

double AxisReading::wavelength_um(double value) const {
    return toUm > 0.0 ? value * toUm : wavelengthFromWavenumber_um(value);
}

bool isAbsurdAxis(double first_um, double last_um) {
    return first_um < infrared.min_um || last_um > infrared.max_um;
}

std::vector<AxisReading> otherReadings(double first_um, double last_um,
                                       const std::vector<SpectralRange>& bands) {
    std::vector<AxisReading> readings;
    if (!isAbsurdAxis(first_um, last_um))
        return readings;
    for (const AxisReading& reading :
         {AxisReading{"cm-1", 0.0}, AxisReading{"nm", 1e-3}, AxisReading{"m", 1e6}}) {
        const SpectralRange range = rangeOf(reading, first_um, last_um);
        if (usual.contains(range))
            readings.push_back(reading);
    }
    std::ranges::stable_partition(readings, [&](const AxisReading& reading) {
        return overlapsAny(rangeOf(reading, first_um, last_um), bands);
    });
    return readings;
}

bool isClear(const std::vector<AxisReading>& readings, double first_um, double last_um,
             const std::vector<SpectralRange>& bands) {
    const auto fits = [&](const AxisReading& reading) {
        return overlapsAny(rangeOf(reading, first_um, last_um), bands);
    };
    return readings.size() == 1 || (readings.size() > 1 && fits(readings.front()) &&
                                    std::ranges::count_if(readings, fits) == 1);
}

std::string axisRepair(const std::vector<AxisReading>& readings, bool isClear) {
    std::string names;
    for (const AxisReading& reading : readings) {
        names += (names.empty() ? "" : " or ") + reading.name;
        if (isClear)
            break;
    }
    if (names.empty())
        return names;
    names += " taken for um?";
    if (isClear) {
        const double toUm = readings.front().toUm;
        names += toUm == 0.0  ? " Read the axis as 10000 / value"
                 : toUm < 1.0 ? " Divide the axis by 1000"
                              : " Multiply the axis by 1000000";
    } else {
        names += " A band (--band) would tell which";
    }
    return names;
}

std::vector<double> readOtherwise(const std::vector<double>& axis_um, const AxisReading& reading,
                                  std::vector<std::size_t>& order) {
    order.resize(axis_um.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (reading.toUm == 0.0)
        std::ranges::reverse(order);
    std::vector<double> result;
    for (const std::size_t i : order)
        result.push_back(reading.wavelength_um(axis_um[i]));
    return result;
}

} // namespace irsg
