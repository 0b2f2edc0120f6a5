#include "irsg/gas/PlumeColumns.h"

#include <algorithm>
#include <utility>

#include "irsg/core/ColumnWords.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// What a column of the head holds: a place by its number, or a number of the gas.
struct HeadColumn {
    std::string head; ///< "x [m]"
    std::size_t place = 0;
    const PlumeColumn* gas = nullptr; ///< null for a place
    bool isNeeded = true;
};

std::vector<HeadColumn> columnsOf(const std::vector<std::string>& places) {
    std::vector<HeadColumn> columns;
    for (std::size_t i = 0; i < places.size(); ++i)
        columns.push_back({places[i] + " [m]", i});
    for (const PlumeColumn& column : plumeGasColumns())
        columns.push_back({std::string(column.name) +
                               (*column.unit != '\0' ? " [" + std::string(column.unit) + "]" : ""),
                           0, &column, column.isNeeded});
    return columns;
}

/// Which column each cell of the head is.
std::vector<const HeadColumn*> readHead(const CsvTable& csv, const std::vector<HeadColumn>& columns,
                                        std::vector<Diagnostic>& diagnostics) {
    std::vector<const HeadColumn*> found;
    std::string expected;
    for (const HeadColumn& column : columns)
        expected += (expected.empty() ? "" : ", ") + column.head;
    for (const CsvCell& cell : csv.rows().front().cells) {
        const auto column =
            std::ranges::find(columns, columnHead(cell.text),
                              [](const HeadColumn& one) { return columnHead(one.head); });
        const bool isKnown = column != columns.end();
        if (!isKnown)
            diagnostics.push_back(csv.diagnostic(cell, "one of " + expected));
        else if (std::ranges::find(found, &*column) != found.end())
            diagnostics.push_back(csv.diagnostic(cell, "each column once"));
        found.push_back(isKnown ? &*column : nullptr);
    }
    for (const HeadColumn& column : columns)
        if (column.isNeeded && std::ranges::find(found, &column) == found.end())
            diagnostics.push_back(csv.diagnostic("no column " + column.head, expected));
    return found;
}

PlumeRow readRow(const CsvTable& csv, const CsvRow& cells,
                 const std::vector<const HeadColumn*>& head, std::vector<Diagnostic>& diagnostics) {
    PlumeRow row;
    row.line = cells.line;
    const std::size_t before = diagnostics.size();
    if (cells.cells.size() != head.size())
        diagnostics.push_back(csv.diagnostic(cells.line,
                                             std::to_string(cells.cells.size()) + " cells",
                                             std::to_string(head.size()) + " as in the head"));
    for (std::size_t i = 0; i < std::min(head.size(), cells.cells.size()); ++i) {
        const auto number = csv.number(cells.cells[i], diagnostics);
        if (!number)
            continue;
        if (head[i]->gas != nullptr)
            head[i]->gas->of(row.gas) = *number;
        else
            row.place_m[head[i]->place] = *number;
    }
    if (diagnostics.size() != before)
        return row;
    GasLayer any = row.gas;
    any.length_m = 1.0;
    for (const Diagnostic& one : gasLayerDiagnostics(any, ""))
        diagnostics.push_back(
            csv.diagnostic(row.line, one.position + " = " + one.value, one.expected));
    return row;
}

} // namespace

const std::vector<PlumeColumn>& plumeGasColumns() {
    static const std::vector<PlumeColumn> all = {
        {"T", "K", true, [](GasLayer& l) -> double& { return l.temperature_K; }},
        {"p", "atm", false, [](GasLayer& l) -> double& { return l.pressure_atm; }},
        {"CO2", "", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CO2); }},
        {"H2O", "", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::H2O); }},
        {"CO", "", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CO); }},
        {"CH4", "", false, [](GasLayer& l) -> double& { return l.fraction(HotGas::CH4); }},
        {"O2", "", false, [](GasLayer& l) -> double& { return l.oxygenFraction; }},
        {"soot", "ppmv", false, [](GasLayer& l) -> double& { return l.soot_ppmv; }}};
    return all;
}

bool hasPlumePlace(const CsvTable& csv, const std::string& name) {
    const ColumnHead wanted = columnHead(name + " [m]");
    return !csv.rows().empty() &&
           std::ranges::any_of(csv.rows().front().cells, [&](const CsvCell& cell) {
               return columnHead(cell.text) == wanted;
           });
}

void readPlumeRows(const CsvTable& csv, const std::vector<std::string>& places,
                   const std::function<void(const PlumeRow&)>& visit,
                   const std::function<std::vector<Diagnostic>(const PlumeRow&)>& check) {
    std::vector<Diagnostic> diagnostics;
    const auto throwThem = [&] {
        if (!diagnostics.empty())
            throw InputError(std::move(diagnostics));
    };
    if (csv.rows().size() < 2)
        diagnostics.push_back(csv.diagnostic("no rows", "a head and the nodes of a plume"));
    throwThem();
    const std::vector<HeadColumn> columns = columnsOf(places);
    const std::vector<const HeadColumn*> head = readHead(csv, columns, diagnostics);
    throwThem();
    for (std::size_t i = 1; i < csv.rows().size(); ++i) {
        const std::size_t before = diagnostics.size();
        const PlumeRow row = readRow(csv, csv.rows()[i], head, diagnostics);
        if (diagnostics.size() == before && check)
            std::ranges::move(check(row), std::back_inserter(diagnostics));
        if (diagnostics.empty())
            visit(row);
    }
    throwThem();
}

} // namespace irsg
