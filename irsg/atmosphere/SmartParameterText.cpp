#include "irsg/atmosphere/SmartParameterText.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "irsg/core/CsvTable.h"

namespace irsg {

namespace {

bool isSameName(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    });
}

const SmartParameter* parameterNamed(std::string_view name) {
    for (const auto& table : {smartParameters(), ownSmartParameters()})
        for (const SmartParameter& parameter : table)
            if (isSameName(parameter.name, name))
                return &parameter;
    return nullptr;
}

/// Nothing where one of the words is no number.
std::optional<std::vector<double>> numbersOf(std::string_view text) {
    constexpr std::string_view between = " ,\t";
    std::vector<double> numbers;
    for (std::size_t at = text.find_first_not_of(between); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(between, at), text.size());
        const auto number = parseNumber(text.substr(at, end - at));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        numbers.push_back(*number);
        at = text.find_first_not_of(between, end);
    }
    return numbers;
}

/// Writes a text into a field; false where it is no value of its kind.
struct Assignment {
    AtmosphereSmartParameters& parameters;
    std::string_view text;

    bool operator()(int AtmosphereSmartParameters::*field) const {
        const auto number = parseNumber(text);
        if (!number || *number != std::round(*number) ||
            std::abs(*number) > std::numeric_limits<int>::max())
            return false;
        parameters.*field = static_cast<int>(*number);
        return true;
    }
    bool operator()(double AtmosphereSmartParameters::*field) const {
        const auto number = parseNumber(text);
        if (!number || !std::isfinite(*number))
            return false;
        parameters.*field = *number;
        return true;
    }
    bool operator()(std::vector<double> AtmosphereSmartParameters::*field) const {
        auto numbers = numbersOf(text);
        if (!numbers || numbers->empty())
            return false;
        parameters.*field = std::move(*numbers);
        return true;
    }
    bool operator()(std::string AtmosphereSmartParameters::*field) const {
        parameters.*field = std::string(text);
        return true;
    }
};

} // namespace

void setFromText(AtmosphereSmartParameters& parameters, std::string_view name,
                 std::string_view text, std::vector<Diagnostic>& diagnostics) {
    const SmartParameter* parameter = parameterNamed(name);
    if (!parameter) {
        diagnostics.push_back(
            {"", std::string(name), "no such parameter",
             "a parameter of AtmosphereSmart, as docs/atmosphere-parameters.md and "
             "'atmosphere info' list them"});
        return;
    }
    if (!std::visit(Assignment{parameters, text}, parameter->field))
        diagnostics.push_back({"", std::string(parameter->name), "'" + std::string(text) + "'",
                               std::string(parameter->range)});
}

} // namespace irsg
