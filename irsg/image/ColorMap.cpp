#include "irsg/image/ColorMap.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

struct ControlPoint {
    double position;
    Rgb color;
};

struct ColorMap::Definition {
    std::string name;
    bool isGrey; ///< two ends, bytes in equal steps; otherwise linear in L*a*b*
    std::vector<ControlPoint> points;
    Rgb below, above, notANumber;
};

namespace {

using Triple = std::array<double, 3>;

// sRGB (IEC 61966-2-1) and CIE 1976 L*a*b*, white D65.
constexpr Triple whiteXyz = {0.950456, 1.0, 1.089058};
constexpr double knee = 6.0 / 29.0;

double labCurve(double x) {
    return x > knee * knee * knee ? std::cbrt(x) : x / (3.0 * knee * knee) + 4.0 / 29.0;
}

double labCurveInverse(double f) {
    return f > knee ? f * f * f : 3.0 * knee * knee * (f - 4.0 / 29.0);
}

Triple labFromRgb(Rgb color) {
    const double r = lightOfByte(color.red), g = lightOfByte(color.green),
                 b = lightOfByte(color.blue);
    const double fx = labCurve((0.412453 * r + 0.357580 * g + 0.180423 * b) / whiteXyz[0]);
    const double fy = labCurve((0.212671 * r + 0.715160 * g + 0.072169 * b) / whiteXyz[1]);
    const double fz = labCurve((0.019334 * r + 0.119193 * g + 0.950227 * b) / whiteXyz[2]);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Rgb rgbFromLab(const Triple& lab) {
    const double fy = (lab[0] + 16.0) / 116.0;
    const double x = whiteXyz[0] * labCurveInverse(fy + lab[1] / 500.0);
    const double y = whiteXyz[1] * labCurveInverse(fy);
    const double z = whiteXyz[2] * labCurveInverse(fy - lab[2] / 200.0);
    return {byteOfLight(3.240479 * x - 1.537150 * y - 0.498535 * z),
            byteOfLight(-0.969256 * x + 1.875992 * y + 0.041556 * z),
            byteOfLight(0.055648 * x - 0.204043 * y + 1.057311 * z)};
}

/// Control points in equal steps from 0 to 1.
std::vector<ControlPoint> evenly(const std::vector<Rgb>& colors) {
    std::vector<ControlPoint> points;
    for (std::size_t i = 0; i < colors.size(); ++i)
        points.push_back(
            {static_cast<double>(i) / static_cast<double>(colors.size() - 1), colors[i]});
    return points;
}

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

} // namespace

std::uint8_t byteOfLight(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * s));
}

double lightOfByte(std::uint8_t byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double lightness(Rgb color) {
    return labFromRgb(color)[0];
}

const std::vector<ColorMap>& ColorMap::all() {
    const Rgb cold{0, 90, 200}, hot{230, 60, 0}, hole{0, 150, 90};
    const Rgb sea{0, 130, 150}, sky{80, 220, 255};
    static const std::vector<Definition> definitions = {
        {"white-hot", true, evenly({black, white}), cold, hot, hole},
        {"black-hot", true, evenly({white, black}), cold, hot, hole},
        // The colours of iron as it warms, lightness nearly straight.
        {"ironbow",
         false,
         {{0.00, {0, 0, 0}},
          {0.15, {32, 0, 94}},
          {0.35, {125, 0, 142}},
          {0.55, {206, 42, 78}},
          {0.75, {245, 128, 14}},
          {0.90, {255, 213, 64}},
          {1.00, {255, 255, 246}}},
         sea,
         sky,
         hole},
        // Ten colours each along the maps of the same name by S. van der Walt and N. Smith (CC0).
        {"inferno", false,
         evenly({{0, 0, 4},
                 {27, 12, 65},
                 {74, 12, 107},
                 {120, 28, 109},
                 {165, 44, 96},
                 {207, 68, 70},
                 {237, 105, 37},
                 {251, 155, 6},
                 {247, 209, 61},
                 {252, 255, 164}}),
         sea, sky, hole},
        {"viridis",
         false,
         evenly({{68, 1, 84},
                 {72, 40, 120},
                 {62, 73, 137},
                 {49, 104, 142},
                 {38, 130, 142},
                 {31, 158, 137},
                 {53, 183, 121},
                 {110, 206, 88},
                 {181, 222, 43},
                 {253, 231, 37}}),
         {10, 10, 10},
         {255, 90, 60},
         {190, 190, 200}},
        // Blue and red ends of equal lightness.
        {"diverging",
         false,
         evenly({{22, 62, 158}, {104, 152, 222}, {255, 255, 255}, {226, 122, 104}, {136, 20, 38}}),
         {0, 140, 140},
         {235, 150, 0},
         {100, 150, 50}},
    };
    static const std::vector<ColorMap> maps = [] {
        std::vector<ColorMap> built;
        for (const Definition& definition : definitions)
            built.push_back(ColorMap(definition));
        return built;
    }();
    return maps;
}

ColorMap::ColorMap(const Definition& definition)
    : name_(definition.name),
      table_(),
      below_(definition.below),
      above_(definition.above),
      notANumber_(definition.notANumber) {
    for (std::size_t i = 0; i < size; ++i) {
        // The two control points around this entry.
        const double t = static_cast<double>(i) / static_cast<double>(size - 1);
        const auto& points = definition.points;
        const auto [below, above, part] =
            bracket(points, t, Beyond::clamp, &ControlPoint::position);
        const Rgb& low = points[below].color;
        const Rgb& high = points[above].color;

        if (definition.isGrey) {
            const auto grey = static_cast<std::uint8_t>(std::lround(lerp(low.red, high.red, part)));
            table_[i] = {grey, grey, grey};
            continue;
        }
        const Triple from = labFromRgb(low), to = labFromRgb(high);
        Triple lab;
        for (std::size_t k = 0; k < 3; ++k)
            lab[k] = lerp(from[k], to[k], part);
        table_[i] = rgbFromLab(lab);
    }
}

const ColorMap& ColorMap::named(const std::string& name) {
    const auto known = std::ranges::find(all(), name, &ColorMap::name_);
    if (known != all().end())
        return *known;
    std::string list;
    for (const std::string& other : names())
        list += (list.empty() ? "" : ", ") + other;
    throw InputError({"", "colour map", "'" + name + "'", "one of " + list});
}

std::vector<std::string> ColorMap::names() {
    std::vector<std::string> names;
    for (const ColorMap& map : all())
        names.push_back(map.name_);
    return names;
}

Rgb ColorMap::at(double t) const {
    if (std::isnan(t))
        return notANumber_;
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(size - 1);
    return table_[static_cast<std::size_t>(std::lround(place))];
}

Rgb ColorMap::color(double value, const DisplayLimits& limits) const {
    if (std::isnan(value))
        return notANumber_;
    if (limits.marksOutside && value < limits.low)
        return below_;
    if (limits.marksOutside && value > limits.high)
        return above_;
    return at(limits.position(value));
}

} // namespace irsg
