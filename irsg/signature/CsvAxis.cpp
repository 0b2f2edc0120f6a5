#include "irsg/signature/CsvAxis.h"

#include <optional>
#include <string>

#include "irsg/core/Remarks.h"

namespace irsg {

SpectralAxis readSpectralAxis(const CsvTable& table, const CsvColumns& columns,
                              std::vector<Diagnostic>& diagnostics) {
    const std::optional<SpectralHead> head = spectralHead(columns.corner.text);
    if (head && head->isInAir)
        remarkOn(table.file(), "wavelengths in air are taken as those in vacuum");
    if (head && head->axis)
        return *head->axis;
    const auto guessed = head ? axisOfValues(columns.axis, true) : std::nullopt;
    if (guessed)
        remarkOn(table.file(), std::string("the head names no unit: the first column is taken as "
                                           "wavelengths in ") +
                                   axisUnit(*guessed) + ", as its values suggest");
    else if (!columns.names.empty())
        diagnostics.push_back(
            table.diagnostic(columns.corner, spectralHeads() + ", for the first column"));
    return guessed.value_or(SpectralAxis::wavelength);
}

void checkSpectralAxis(const CsvTable& table, const CsvColumns& columns,
                       std::vector<Diagnostic>& diagnostics) {
    const auto& axis = columns.axis;
    const bool descending = axis.size() > 1 && axis[1] < axis[0];
    for (std::size_t i = 0; i < axis.size(); ++i) {
        if (axis[i] <= 0.0) {
            diagnostics.push_back(table.diagnostic(columns.axisCells[i], "a positive axis value"));
        } else if (i > 0 && !(descending ? axis[i] < axis[i - 1] : axis[i] > axis[i - 1])) {
            diagnostics.push_back(table.diagnostic(
                columns.axisCells[i], std::string("a strictly ") +
                                          (descending ? "descending" : "ascending") +
                                          " axis: a value " + (descending ? "below " : "above ") +
                                          columns.axisCells[i - 1].text));
        }
    }
}

std::vector<double> wavelengthsOf(const CsvColumns& columns, SpectralAxis axis) {
    std::vector<double> wavelengths_um;
    for (const double position : columns.axis)
        wavelengths_um.push_back(wavelengthOn_um(axis, position));
    return wavelengths_um;
}

std::string csvCell(const std::string& name) {
    if (name.find_first_of(",\"#") == std::string::npos)
        return name;
    std::string quoted = "\"";
    for (const char c : name)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

} // namespace irsg
