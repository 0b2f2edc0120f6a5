#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace irsg {

/// A word that may stand at the head of a column, and the one of ours that it means.
struct ColumnWord {
    std::string_view word; ///< as plainHead() gives it; symbols of one or two letters as they are
    std::string_view name; ///< "transmittance"
};
/// All words at heads of columns that are read as others: those of German and French, other words
/// of English and symbols. What means two things (German Extinktion, which is absorbance as well,
/// or Emission) is not among them.
std::span<const ColumnWord> columnWords();

/// A unit as it may be written, and as we write it.
struct ColumnUnit {
    std::string_view spelling; ///< as plainHead() gives it; of up to three letters as they are
    std::string_view unit;     ///< "um", "K", "hPa"
};
/// All spellings of units at heads of columns. Units that differ by a factor are different ones.
std::span<const ColumnUnit> columnUnits();
/// The unit that a text is, in any spelling; no value for other texts. `1` and `-` are none: "".
std::optional<std::string_view> columnUnit(std::string_view text);

/// What a head of a column says, the same for all that mean the same: "Temperatur in °C",
/// "température [°C]" and "temperature_C" are {"temperature", "C"}.
struct ColumnHead {
    std::string name; ///< small letters, words joined by _; "" for a unit alone in brackets
    std::string unit; ///< as we write it where it is known, else as it stands; "" for none
    bool operator==(const ColumnHead&) const = default;
};
/// A unit is found in the brackets at the end, behind a slash or "in", and where it is known also
/// behind a blank, a comma or _. A per cent sign or its words anywhere are the unit "%".
ColumnHead columnHead(std::string_view head);

/// The letters of a head as ASCII: accents are left out, umlauts are two letters (`ae`), Å is
/// `angstrom`, µ is `u`, ° is `deg`, small raised digits are digits. Text that is not UTF-8 is
/// Latin-1. Other characters are `?`.
std::string plainHead(std::string_view head);

} // namespace irsg
