#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// What readers of columns say of a text in Latin-1.
inline constexpr const char* latin1Words = "bytes that are not UTF-8 are taken as Latin-1";

/// How a text writes columns of numbers.
struct ColumnDialect {
    char separator = ','; ///< ',', ';', '|' or a tab; ' ' stands for blanks and tabs in any number
    char decimal = '.';   ///< '.' or ','; a decimal comma between separating commas is in quotes

    bool isPlain() const { return separator == ',' && decimal == '.'; }
    /// "columns separated by semicolons, decimal commas".
    std::string words() const;
    bool operator==(const ColumnDialect&) const = default;
};

/// The dialect of a text, found from all its lines: that in which most rows are rows of two numbers
/// or more and of one width. Commas and decimal points go first where others do as well; so `1,5`
/// is two numbers in a text of such rows alone. Lines that begin with # do not count; a first line
/// `sep=;` as spreadsheets write it decides the separator. Throws InputError naming file, line,
/// value and expectation for what can be read in two ways: `1,5, 2,5`; quoted numbers such as
/// "1,234" between commas, which may be thousands; pairs of columns such as `0,05` where a number
/// must not begin with a zero.
ColumnDialect columnDialectOf(std::string_view text, const std::string& file);

/// One cell of a line, without the blanks and quotes around it.
struct ColumnCell {
    std::string_view text; ///< of a quoted cell what stands in the quotes, where "" is one quote
    std::string_view rest; ///< behind the closing quote, as a rule empty
    bool isQuoted = false;
};

/// Splits a line into `cells`; false where a quote is never closed. Blanks as separators keep what
/// follows in square or round brackets with the cell before it (`wavelength [um]`).
bool splitColumns(std::string_view line, char separator, std::vector<ColumnCell>& cells);

/// The text of a cell with its quotes resolved.
std::string textOf(const ColumnCell& cell);

/// The number that a cell holds as parseNumber takes it: a decimal comma becomes a point and an
/// exponent with D, or without a letter where Fortran leaves it out (`1.2-103`), one with e. No
/// value where the cell holds no number in this dialect. NaN and infinity in letters are kept.
std::optional<std::string> plainNumber(std::string_view cell, char decimal);

/// The same for a cell of a table, whose digits may stand in groups of three: with blanks that do
/// not break or apostrophes between them, with blanks in quotes or where semicolons, tabs or bars
/// separate cells, or with the other sign before a decimal sign (`1.234,5`; `1.234` alone is not).
std::optional<std::string> cellNumber(const ColumnCell& cell, const ColumnDialect& dialect);

/// Whether a cell holds a number, NaN or infinity.
bool isNumberCell(const ColumnCell& cell, const ColumnDialect& dialect);

/// Whether a row consists of numbers and empty cells, with one number at least.
bool isNumberRow(const std::vector<ColumnCell>& cells, const ColumnDialect& dialect);

/// The next line of a text, of which it is taken away: lines end in LF, CRLF or CR.
std::string_view takeLine(std::string_view& rest);

/// Whether a line is a comment: # in front, or in the quotes of its first cell.
bool isCommentLine(std::string_view line);

/// The separator that a line `sep=;` names; no value for any other line.
std::optional<char> statedSeparator(std::string_view line);

} // namespace irsg
