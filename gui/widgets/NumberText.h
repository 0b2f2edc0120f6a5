#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace smat::gui {

/// What a person typed into a field for a number.
struct TypedNumber {
    std::optional<double> value; ///< in the unit of the field; none where the text is no number
    QString problem; ///< "'2.500,0' has a point and a comma", empty where there is a value
};
/// The one rule of all number fields of the window. A point or a single comma is the decimal sign:
/// "4.2", "4,2", " 1e-3 ", "−2,5e5"; both in one number and a repeated one are refused, since they
/// can be read in two ways. Digits are not grouped. Behind the number the unit of the field may
/// stand, or another one of the same quantity: "2 km" is 2000 in a field in m, "27 °C" is 300.15 in
/// one in K, "85 %" is 0.85 in one without a unit. Units: as they are shown, or in ASCII ("um").
/// A difference of temperatures has no zero: units whose zero is elsewhere are refused for it.
enum class NumberMeaning { value, difference };
TypedNumber typedNumber(const QString& text, const QString& unit = {},
                        NumberMeaning meaning = NumberMeaning::value);
/// The same as a text for readers that know a decimal point alone; what is no number as it is.
QString plainNumber(const QString& text, const QString& unit);

/// The number alone: "4.2", "4,2", " 1e-3 ". Not "1,234.5".
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
