#include "irsg/atmosphere/AtmosphereDescription.h"

#include <array>
#include <charconv>

namespace irsg {

namespace {

/// In no language: with a decimal point everywhere.
std::string textOf(double value, std::chars_format format, int precision) {
    std::array<char, 400> text; // the largest double has 309 digits
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
    return {text.data(), end};
}

} // namespace

std::string general(double value, int digits) {
    return textOf(value, std::chars_format::general, digits);
}

std::string fixed(double value, int decimals) {
    return textOf(value, std::chars_format::fixed, decimals);
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace irsg
