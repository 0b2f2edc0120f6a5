#include "irsg/signature/CsvAxis.h"

#include "irsg/radiometry/Units.h"

namespace irsg {

SpectralAxis readSpectralAxis(const CsvTable& table, const CsvColumns& columns,
                              std::vector<Diagnostic>& diagnostics) {
    const CsvCell& cell = columns.corner;
    if (cell.text == "um" || cell.text == "\u00b5m" || cell.text == "\u03bcm")
        return SpectralAxis::wavelength;
    if (cell.text == "cm-1" || cell.text == "cm^-1" || cell.text == "cm\u207b\u00b9")
        return SpectralAxis::wavenumber;
    if (!columns.names.empty()) {
        diagnostics.push_back(
            table.diagnostic(cell, "'um' or 'cm-1', the unit of the first column"));
    }
    return SpectralAxis::wavelength;
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
    for (const double position : columns.axis) {
        wavelengths_um.push_back(
            axis == SpectralAxis::wavenumber ? wavelengthFromWavenumber_um(position) : position);
    }
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
