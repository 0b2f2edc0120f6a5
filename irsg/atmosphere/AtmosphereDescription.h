#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace irsg {

struct AtmosphereFact;
/// Named facts in the order in which they are told.
using AtmosphereFacts = std::vector<AtmosphereFact>;
struct AtmosphereFactValue;
/// Facts without names.
using AtmosphereFactList = std::vector<AtmosphereFactValue>;

/// A value: a number, text, named facts below it, or a list.
struct AtmosphereFactValue {
    std::variant<bool, std::int64_t, double, std::string, AtmosphereFacts, AtmosphereFactList>
        value;
};

/// A named value; the name ends in the unit of a number that has one: "air_temperature_K".
struct AtmosphereFact {
    std::string name;
    AtmosphereFactValue value;
};

/// What an atmosphere tells of itself beyond its name, base and quantities: lines for a reader, and
/// the same as facts for a program. Lines that belong to the line before are indented by two
/// blanks.
struct AtmosphereDescription {
    std::vector<std::string> lines;
    AtmosphereFacts facts;
};

/// A number with so many significant digits: "0.05", "1e+07".
std::string general(double value, int digits = 6);
/// A number with so many decimals: "294.20".
std::string fixed(double value, int decimals);
/// "1 run", "3 runs".
std::string counted(std::size_t count, const std::string& noun);

} // namespace irsg
