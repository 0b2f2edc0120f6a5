#include "irsg/image/AxisTicks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, 512> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    std::string out(text.data(), end);
    // No "-0", and the sign as it is printed.
    if (out.find_first_not_of("-0.") == std::string::npos && out.starts_with('-'))
        out.erase(0, 1);
    if (out.starts_with('-'))
        out.replace(0, 1, "\u2212");
    return out;
}

/// Of what lies from `low` to `high` the roundest: 0, else, of the multiples of the largest of 1, 2
/// and 5 times a power of ten that has any there, the one nearest to `wanted`; of two digits.
double roundestBetween(double low, double high, double wanted) {
    if (low <= 0.0 && high >= 0.0)
        return 0.0;
    const double largest = std::max(std::abs(low), std::abs(high));
    const double power = std::floor(std::log10(largest)), unit = std::pow(10.0, power - 1.0);
    for (const double step : {50.0, 20.0, 10.0, 5.0, 2.0, 1.0}) {
        const double first = std::ceil(low / (step * unit));
        const double last = std::floor(high / (step * unit));
        if (first <= last)
            return std::clamp(std::round(wanted / (step * unit)), first, last) * step * unit;
    }
    return std::round(wanted / unit) * unit;
}

/// Decimals that show the two digits of a rounded value.
int decimalsOf(double value) {
    if (value == 0.0)
        return 0;
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    const double second = std::abs(value) * std::pow(10.0, 1 - power);
    return std::max(0, (std::lround(second) % 10 == 0 ? 0 : 1) - power);
}

/// Round values at about equal steps of colour: the roundest of each step.
void addAlongColors(const DisplayLimits& limits, int most, double unit, AxisTicks& ticks) {
    // Parts of a step; values of which each has a colour of its own lie too close for a wide reach.
    constexpr double nearest = 0.6;
    const double reach = limits.scale == ColorScale::equalized ? 0.25 : 0.45;
    const double step = 1.0 / (most - 1);
    const auto scaledAt = [&](double position) { return limits.value(position) / unit; };
    double before = -1.0;
    for (int i = 0; i < most; ++i) {
        const double middle = i * step;
        const double scaled = roundestBetween(scaledAt(middle - reach * step),
                                              scaledAt(middle + reach * step), scaledAt(middle));
        const double value = scaled * unit, position = limits.position(value);
        if (value < limits.low || value > limits.high || position - before < nearest * step)
            continue;
        before = position;
        ticks.values.push_back(value);
        ticks.labels.push_back(fixed(scaled, decimalsOf(scaled)));
    }
}

} // namespace

std::pair<double, int> roundStep(double least) {
    const int power = static_cast<int>(std::floor(std::log10(least) + 1e-9));
    for (const double mantissa : {1.0, 2.0, 5.0})
        if (mantissa * std::pow(10.0, power) >= least * (1.0 - 1e-9))
            return {mantissa * std::pow(10.0, power), power};
    return {std::pow(10.0, power + 1), power + 1};
}

AxisTicks axisTicks(const DisplayLimits& limits, int mostTicks) {
    const double low = limits.low, high = limits.high;
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high))
        throw InputError({"", "limits", numberText(low) + " to " + numberText(high),
                          "two finite numbers, the lower one first"});

    // Labels are divided by a power of ten where they would grow long.
    AxisTicks ticks;
    const double largest = std::max(std::abs(low), std::abs(high));
    if (largest < 0.01 || largest >= 1e5)
        ticks.exponent =
            std::max(3 * static_cast<int>(std::floor(std::log10(largest) / 3.0 + 1e-9)), -300);
    const auto scaled = [&ticks](double value) {
        return ticks.exponent >= 0 ? value / std::pow(10.0, ticks.exponent)
                                   : value * std::pow(10.0, -ticks.exponent);
    };

    const int most = std::max(mostTicks, 2);
    if (limits.scale != ColorScale::linear) {
        addAlongColors(limits, most, std::pow(10.0, ticks.exponent), ticks);
        if (ticks.values.size() > 1)
            return ticks;
        ticks.values.clear();
        ticks.labels.clear();
    }

    // The multiples of the step that lie inside; a step that gives too many grows once more.
    double least = (scaled(high) - scaled(low)) / most;
    for (int attempt = 0; attempt < 3 && least > 0.0 && std::isfinite(least); ++attempt) {
        const auto [step, power] = roundStep(least);
        const double first = std::ceil(scaled(low) / step - 1e-6);
        const double last = std::floor(scaled(high) / step + 1e-6);
        if (last - first + 1.0 > most) {
            least = step * 1.01;
            continue;
        }
        if (!(std::abs(first) < 1e12 && std::abs(last) < 1e12) || last - first < 1.0)
            break;
        for (double k = first; k <= last; ++k) {
            const double value = k * step;
            const double plain = ticks.exponent >= 0 ? value * std::pow(10.0, ticks.exponent)
                                                     : value / std::pow(10.0, -ticks.exponent);
            ticks.values.push_back(std::clamp(plain, low, high));
            ticks.labels.push_back(fixed(value, std::max(0, -power)));
        }
        return ticks;
    }
    // The ends: as many digits as tell them apart to a hundredth, at most seven.
    ticks.values = {low, high};
    const auto powerOf = [](double value) {
        return static_cast<int>(std::floor(std::log10(value)));
    };
    const double apart = std::max(scaled(high) - scaled(low), std::numeric_limits<double>::min());
    const int decimals =
        std::clamp(std::min(6 - powerOf(scaled(largest)), 2 - powerOf(apart)), 0, 9);
    ticks.labels = {fixed(scaled(low), decimals), fixed(scaled(high), decimals)};
    return ticks;
}

std::string superscript(int number) {
    static const std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                       "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out;
    for (const char c : std::to_string(number))
        out += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return out;
}

std::string prettyUnit(const std::string& unit) {
    std::string out;
    for (std::size_t begin = 0; begin <= unit.size();) {
        const std::size_t end = std::min(unit.find(' ', begin), unit.size());
        std::string symbol = unit.substr(begin, end - begin);
        begin = end + 1;

        // A symbol of letters, then perhaps an exponent.
        const std::size_t letters = symbol.find_first_of("-0123456789");
        int exponent = 1;
        if (letters != std::string::npos) {
            const char* last = symbol.data() + symbol.size();
            const auto [stop, error] = std::from_chars(symbol.data() + letters, last, exponent);
            if (letters == 0 || stop != last || error != std::errc())
                return unit;
            symbol.resize(letters);
        }
        if (symbol.empty())
            return unit;
        if (symbol == "um")
            symbol = "µm";
        if (symbol == "deg")
            symbol = "°";
        out += (out.empty() ? "" : "·") + symbol + (exponent == 1 ? "" : superscript(exponent));
    }
    return out;
}

} // namespace irsg
