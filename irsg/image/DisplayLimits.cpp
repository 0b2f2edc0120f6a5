#include "irsg/image/DisplayLimits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/image/ImageStatistics.h"

namespace irsg {

namespace {

constexpr std::array<std::pair<ColorScale, const char*>, 5> names{{
    {ColorScale::automatic, "auto"},
    {ColorScale::linear, "linear"},
    {ColorScale::squareRoot, "square-root"},
    {ColorScale::logarithmic, "logarithmic"},
    {ColorScale::equalized, "equalized"},
}};

/// Of the logarithmic scale: the slope at its lower end in terms of that of a straight line, but
/// for a factor ln(1 + steepness).
constexpr double steepness = 1e4;
/// Steps between the levels of an equalized scale.
constexpr std::size_t levelSteps = 256;

/// Limits so many times as wide as the cooler part of an object are the most that a straight line
/// and a square root show it in.
constexpr double widestLinear = 4.0, widestSquareRoot = 30.0;

/// How far the cooler three quarters of an object reach above the least value that is shown: skin
/// without pipes and plumes, however large these are. The background, which is uniform, is an end
/// of the limits of the object.
double coolSpread(std::span<const float> plane) {
    const DisplayLimits object = objectLimits(plane);
    std::vector<float> inside;
    for (const float value : plane)
        if (static_cast<double>(value) > object.low && static_cast<double>(value) < object.high)
            inside.push_back(value);
    const double cool = inside.empty() ? object.high : percentile(inside, 75.0);
    return cool - object.low;
}

ColorScale scaleFor(const DisplayLimits& limits, const std::vector<std::span<const float>>& shown) {
    double object = 0.0;
    for (const std::span<const float> plane : shown)
        object = std::max(object, coolSpread(plane));
    const double width = limits.high - limits.low;
    if (!(object > 0.0) || width <= widestLinear * object)
        return ColorScale::linear;
    return width <= widestSquareRoot * object ? ColorScale::squareRoot : ColorScale::logarithmic;
}

/// Where a value lies among ascending levels, 0 at the first to 1 at the last.
double positionAmong(const std::vector<double>& levels, double value) {
    const Bracket at = bracket(levels, value);
    return (static_cast<double>(at.below) + at.fraction) / static_cast<double>(levels.size() - 1);
}

} // namespace

std::vector<std::string> colorScaleNames() {
    std::vector<std::string> all;
    for (const auto& [scale, name] : names)
        all.emplace_back(name);
    return all;
}

std::string nameOf(ColorScale scale) {
    return std::ranges::find(names, scale, &std::pair<ColorScale, const char*>::first)->second;
}

ColorScale colorScaleNamed(const std::string& name) {
    std::string list;
    for (const auto& [scale, known] : names) {
        if (name == known)
            return scale;
        list += (list.empty() ? "" : ", ") + std::string(known);
    }
    throw InputError({"", "colour scale", "'" + name + "'", "one of " + list});
}

bool DisplayLimits::operator==(const DisplayLimits& other) const {
    const bool sameLevels =
        levels == other.levels || (levels && other.levels && *levels == *other.levels);
    return low == other.low && high == other.high && scale == other.scale && sameLevels &&
           marksOutside == other.marksOutside;
}

double DisplayLimits::position(double value) const {
    const double part = std::clamp((value - low) / (high - low), 0.0, 1.0);
    switch (scale) {
    case ColorScale::squareRoot:
        return std::sqrt(part);
    case ColorScale::logarithmic:
        return std::log1p(steepness * part) / std::log1p(steepness);
    case ColorScale::equalized:
        return levels ? positionAmong(*levels, value) : part;
    case ColorScale::automatic:
    case ColorScale::linear:
        break;
    }
    return part;
}

double DisplayLimits::value(double position) const {
    double part = std::clamp(position, 0.0, 1.0);
    if (scale == ColorScale::squareRoot) {
        part *= part;
    } else if (scale == ColorScale::logarithmic) {
        part = std::expm1(part * std::log1p(steepness)) / steepness;
    } else if (scale == ColorScale::equalized && levels) {
        const double place = part * static_cast<double>(levels->size() - 1);
        const auto step = std::min(static_cast<std::size_t>(place), levels->size() - 2);
        const double below = (*levels)[step], above = (*levels)[step + 1];
        return below + (place - static_cast<double>(step)) * (above - below);
    }
    return low + part * (high - low);
}

DisplayLimits DisplayLimits::with(ColorScale wanted,
                                  const std::vector<std::span<const float>>& shown) const {
    DisplayLimits limits{low, high, wanted, {}, marksOutside};
    if (wanted == ColorScale::automatic)
        limits.scale = scaleFor(limits, shown);
    if (wanted != ColorScale::equalized)
        return limits;
    std::vector<double> values{low, high};
    for (const std::span<const float> plane : shown)
        for (const float value : plane)
            if (static_cast<double>(value) > low && static_cast<double>(value) < high)
                values.push_back(static_cast<double>(value));
    std::ranges::sort(values);
    values.erase(std::ranges::unique(values).begin(), values.end());
    // Few values have a step of colour each.
    const std::size_t steps = std::min(levelSteps, values.size() - 1);
    auto levels = std::make_shared<std::vector<double>>();
    for (std::size_t i = 0; i <= steps; ++i)
        levels->push_back(values[i * (values.size() - 1) / steps]);
    limits.levels = std::move(levels);
    return limits;
}

} // namespace irsg
