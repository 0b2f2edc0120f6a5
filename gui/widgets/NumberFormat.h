#pragma once

#include <filesystem>
#include <string>

#include <QString>

namespace smat::gui {

inline QString textOf(const std::string& text) {
    return QString::fromStdString(text);
}
inline QString textOf(const std::filesystem::path& file) {
    return QString::fromStdString(file.string());
}
/// "1.2346e+05": six significant digits for read-outs, "no value" where it is not finite.
QString formattedNumber(double value);
/// "185100": as many significant digits as one reads in a sentence, without an exponent from 0.0001
/// to 10 million; "no value" where it is not finite.
QString sentenceNumber(double value, int digits = 4);
/// A number that reads back as it is; nothing where it is not finite.
QString exactNumber(double value);
/// "W m-2 sr-1" as "W·m⁻²·sr⁻¹"; a unit that is no quantity's as it is.
QString formattedUnit(const std::string& unit);
/// The same for units behind numbers in a sentence: "0 to 350°, 640 × 512 px" for
/// "0 to 350 deg, 640 x 512 px".
QString withFormattedUnits(QString sentence);

} // namespace smat::gui
