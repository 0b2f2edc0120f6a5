#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace irsg {

/// A unit of length that somebody wrote into a comment or a name of a file whose format has no
/// place for it.
struct UnitInWords {
    double unit_m = 1.0; ///< 1e-6 to 1e6
    std::string words;   ///< "millimeters"
    bool operator==(const UnitInWords&) const = default;
};

/// Finds a unit in a line of plain words: "File units = millimeters", "UNITS=mm", "all dimensions
/// in inches", "1 unit = 0.01 m". A name of a unit counts only behind a word such as unit,
/// dimension or scale. Nothing where there is none, where two differ ("mm to metres"), and where it
/// is a rate ("units per metre"). Upper and lower case are alike.
std::optional<UnitInWords> unitInWords(std::string_view line);

} // namespace irsg
