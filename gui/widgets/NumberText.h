#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace smat::gui {

/// A number as people and spreadsheets write it: "4.2", "4,2", " 1e-3 ". Not "1,234.5".
std::optional<double> numberOf(const QString& text);
/// The shortest text that reads back as the number.
QString textOf(double value);

/// Rows from a spreadsheet or a text file: columns apart by tabs, semicolons, commas or blanks,
/// with a point or a comma in numbers. A first row without any number is a heading.
struct PastedRows {
    std::vector<std::vector<double>> rows; ///< each as long as the first
    QString problem;                       ///< "row 3, column 2: 'n/a' is not a number", or empty
};
PastedRows rowsOf(const QString& text);

} // namespace smat::gui
