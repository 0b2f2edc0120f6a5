#include "irsg/signature/CsvColumns.h"

#include <set>

namespace irsg {

namespace {

std::string expectedNumber(const CsvCell& cell) {
    return cell.text.find(',') != std::string::npos ? "a finite number with a decimal point"
                                                    : "a finite number";
}

std::string expectedCells(std::size_t found, std::size_t wanted) {
    std::string text = std::to_string(wanted) + " cells";
    if (found > wanted)
        text += " (with decimal points, not commas?)";
    return text;
}

} // namespace

CsvColumns readColumns(const CsvTable& table, std::size_t fewestNodes,
                       std::vector<Diagnostic>& diagnostics) {
    CsvColumns columns;
    const auto& rows = table.rows();
    const std::string needed = "a row of names and at least " + std::to_string(fewestNodes) +
                               (fewestNodes == 1 ? " row" : " rows") + " of numbers";
    if (rows.size() < fewestNodes + 1) {
        diagnostics.push_back(table.diagnostic(std::to_string(rows.size()) + " rows", needed));
        return columns;
    }

    // The names, each once.
    const CsvRow& head = rows.front();
    columns.corner = head.cells.front();
    std::set<std::string> seen;
    for (std::size_t i = 1; i < head.cells.size(); ++i) {
        const CsvCell& name = head.cells[i];
        if (name.text.empty()) {
            diagnostics.push_back(table.diagnostic(name, "the name of a component"));
        } else if (parseNumber(name.text)) {
            diagnostics.push_back(
                table.diagnostic(name, "the name of a component (is the row of names missing?)"));
        } else if (!seen.insert(name.text).second) {
            diagnostics.push_back(table.diagnostic(name, "each name once"));
        }
        columns.names.push_back(name);
    }
    if (columns.names.empty()) {
        diagnostics.push_back(table.diagnostic(head.line, columns.corner.text,
                                               "at least one name behind the first cell"));
    }

    // The numbers, in rows as long as the row of names.
    columns.cells.resize(columns.names.size());
    columns.values.resize(columns.names.size());
    for (std::size_t r = 1; r < rows.size(); ++r) {
        const CsvRow& row = rows[r];
        if (row.cells.size() != head.cells.size()) {
            diagnostics.push_back(
                table.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                 expectedCells(row.cells.size(), head.cells.size())));
            continue;
        }
        columns.axis.push_back(
            table.number(row.cells.front(), diagnostics, expectedNumber(row.cells.front()))
                .value_or(0.0));
        columns.axisCells.push_back(row.cells.front());
        for (std::size_t i = 0; i < columns.names.size(); ++i) {
            const CsvCell& cell = row.cells[i + 1];
            columns.values[i].push_back(
                table.number(cell, diagnostics, expectedNumber(cell)).value_or(0.0));
            columns.cells[i].push_back(cell);
        }
    }
    return columns;
}

} // namespace irsg
