#include "irsg/atmosphere/engine/SolarTable.h"

#include <array>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

SolarTable SolarTable::read(const std::filesystem::path& file) {
    constexpr std::array<const char*, 3> header = {"lower [cm-1]", "upper [cm-1]",
                                                   "irradiance [W m-2 cm]"};
    const CsvTable csv = CsvTable::read(file);
    if (csv.rows().size() < 2)
        throw InputError(csv.diagnostic(std::to_string(csv.rows().size()) + " rows",
                                        "a header and the sun's spectrum"));
    std::vector<Diagnostic> diagnostics;
    const CsvRow& names = csv.rows().front();
    for (std::size_t i = 0; i < header.size(); ++i)
        if (i >= names.cells.size() || names.cells[i].text != header[i])
            diagnostics.push_back(csv.diagnostic(
                names.line, i < names.cells.size() ? names.cells[i].text : "no column",
                std::string(header[i]) + " as column " + std::to_string(i + 1)));

    SolarTable table;
    for (std::size_t r = 1; r < csv.rows().size(); ++r) {
        const CsvRow& row = csv.rows()[r];
        if (row.cells.size() != header.size()) {
            diagnostics.push_back(csv.diagnostic(row.line,
                                                 std::to_string(row.cells.size()) + " cells",
                                                 "lower and upper wavenumber and irradiance"));
            continue;
        }
        const std::size_t before = diagnostics.size();
        const double lower = csv.number(row.cells[0], diagnostics).value_or(0.0);
        const double upper = csv.number(row.cells[1], diagnostics).value_or(0.0);
        const double value = csv.number(row.cells[2], diagnostics).value_or(0.0);
        if (diagnostics.size() > before)
            continue;
        if (table.edges_per_cm_.empty()) {
            table.edges_per_cm_.push_back(lower);
            table.sums_.push_back(0.0);
        }
        if (lower != table.edges_per_cm_.back())
            diagnostics.push_back(
                csv.diagnostic(row.cells[0], "the upper end of the row before, " +
                                                 numberText(table.edges_per_cm_.back())));
        if (!(upper > lower))
            diagnostics.push_back(csv.diagnostic(row.cells[1], "more than " + numberText(lower)));
        if (!(value >= 0.0))
            diagnostics.push_back(csv.diagnostic(row.cells[2], "an irradiance >= 0"));
        table.edges_per_cm_.push_back(upper);
        table.sums_.push_back(table.sums_.back() + value * (upper - lower));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

double SolarTable::below(double wavenumber_per_cm) const {
    return interpolate(edges_per_cm_, sums_, wavenumber_per_cm);
}

} // namespace irsg
