#include "irsg/atmosphere/engine/EvenTable.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace irsg {

EvenTable EvenTable::read(const std::filesystem::path& file,
                          const std::vector<std::string>& columns) {
    const CsvTable csv = CsvTable::read(file);
    std::vector<std::string> expected = {"wavenumber [cm-1]"};
    expected.insert(expected.end(), columns.begin(), columns.end());
    if (csv.rows().size() < 3)
        throw InputError(csv.diagnostic(std::to_string(csv.rows().size()) + " rows",
                                        "a header and at least two rows"));

    std::vector<Diagnostic> diagnostics;
    const CsvRow& header = csv.rows().front();
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (i >= header.cells.size() || header.cells[i].text != expected[i])
            diagnostics.push_back(csv.diagnostic(
                header.line, i < header.cells.size() ? header.cells[i].text : "no column",
                expected[i] + " as column " + std::to_string(i + 1)));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    std::vector<double> axis;
    EvenTable table;
    table.columns_.resize(columns.size());
    for (std::size_t r = 1; r < csv.rows().size(); ++r) {
        const CsvRow& row = csv.rows()[r];
        if (row.cells.size() != expected.size()) {
            diagnostics.push_back(csv.diagnostic(row.line,
                                                 std::to_string(row.cells.size()) + " cells",
                                                 std::to_string(expected.size()) + " cells"));
            continue;
        }
        axis.push_back(csv.number(row.cells[0], diagnostics).value_or(0.0));
        for (std::size_t c = 0; c < columns.size(); ++c)
            table.columns_[c].push_back(csv.number(row.cells[c + 1], diagnostics).value_or(0.0));
        const std::size_t n = axis.size();
        if (n > 2 && std::abs((axis[n - 1] - axis[n - 2]) - (axis[1] - axis[0])) > 1e-6)
            diagnostics.push_back(csv.diagnostic(row.cells[0], "wavenumbers in even steps of " +
                                                                   numberText(axis[1] - axis[0])));
    }
    if (diagnostics.empty() && !(axis[1] > axis[0]))
        diagnostics.push_back(csv.diagnostic("wavenumbers that fall", "ascending wavenumbers"));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    table.lower_per_cm_ = axis[0];
    table.step_per_cm_ = (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
    table.rows_ = axis.size();
    return table;
}

EvenTable::Place EvenTable::place(double wavenumber_per_cm) const {
    if (!(wavenumber_per_cm >= lower_per_cm() && wavenumber_per_cm <= upper_per_cm()))
        return {};
    const double rows = (wavenumber_per_cm - lower_per_cm_) / step_per_cm_;
    const auto row = std::min(static_cast<std::size_t>(rows), rows_ - 2);
    return {row, rows - static_cast<double>(row), true};
}

double EvenTable::at(std::size_t column, const Place& place) const {
    if (!place.inside)
        return 0.0;
    const std::vector<double>& values = columns_[column];
    return values[place.row] + place.part * (values[place.row + 1] - values[place.row]);
}

} // namespace irsg
