#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace irsg {

/// JSON as text that depends on the value alone: keys sorted (whole numbers by value, before
/// words), numbers as numberText writes them. The texts in it are
/// UTF-8 (LogicError).
std::string compactJson(const nlohmann::json& value);
/// The same for people: two blanks of indentation, one key a line, and a list of plain values on
/// one line, so that each row of a table is one line of a comparison.
std::string prettyJson(const nlohmann::json& value);

} // namespace irsg
