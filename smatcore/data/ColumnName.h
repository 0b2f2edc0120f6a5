#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace smat {

struct ResultColumn;
class ResultTable;

/// The parts of a column's key: `[PREFIX]OBJECT.QUANTITY@BAND`, such as
/// "near.contrast_intensity@3-5um". The object is there in tables of several objects (without it a
/// column is the sum of all), the band in tables of several bands. What stands before a point is an
/// object only where a known quantity follows.
struct ColumnName {
    /// "error_", of one cause "error_sampling_", "error_air_", "error_background_" or
    /// "error_exchange_", "difference_", "relative_difference_" or "".
    std::string prefix;
    std::string object;   ///< "near", "near/exhaust" of a part of it, or ""
    std::string quantity; ///< "contrast_intensity"
    std::string band;     ///< "3-5um", or ""

    static ColumnName of(std::string_view key);
    std::string key() const;
    /// What stands before the point of a column of a part: "near/exhaust".
    static std::string ofPart(std::string_view object, std::string_view part);
    /// "exhaust" of such a column, else "".
    std::string part() const;
    /// Without object and band: columns of one series are drawn together.
    std::string series() const { return prefix + quantity; }
    /// "near, 3-5 um": what tells the columns of a series apart; "" where nothing does.
    std::string which() const;

    bool operator==(const ColumnName&) const = default;
};

/// The measured columns of a series, or the one column of that key; empty where there are none.
std::vector<const ResultColumn*> columnsOf(const ResultTable& table, std::string_view series);

/// Names as parts of keys, which tables, plots and head lines show: as they were written but for
/// control characters, which become blanks, and `/`, which stands before a part and becomes the
/// division slash (U+2215). What is empty becomes "object", and a name that occurs before gets -2,
/// -3, ... behind it.
std::vector<std::string> distinctLabels(std::vector<std::string> names);
/// The same as parts of file names: what programs or file systems take for something else becomes
/// `_`.
std::vector<std::string> distinctFileLabels(std::vector<std::string> names);

} // namespace smat
