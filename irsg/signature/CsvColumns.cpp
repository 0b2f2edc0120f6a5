#include "irsg/signature/CsvColumns.h"

#include <set>

#include "irsg/signature/Utf8.h"

namespace irsg {

CsvColumns readColumns(const CsvTable& table, std::size_t fewestNodes,
                       std::vector<Offence>& offences) {
    CsvColumns columns;
    const auto& rows = table.rows();
    const std::string needed = "a row of names and at least " + std::to_string(fewestNodes) +
                               (fewestNodes == 1 ? " row" : " rows") + " of numbers";
    if (rows.size() < fewestNodes + 1) {
        offences.push_back(table.offence(std::to_string(rows.size()) + " rows", needed));
        return columns;
    }

    // The names, each once.
    const CsvRow& head = rows.front();
    columns.corner = head.cells.front();
    std::set<std::string> seen;
    for (std::size_t i = 1; i < head.cells.size(); ++i) {
        const CsvCell& name = head.cells[i];
        if (name.text.empty()) {
            offences.push_back(table.offence(name, "the name of a component"));
        } else if (!isUtf8(name.text)) {
            offences.push_back(
                {table.file(),
                 "line " + std::to_string(name.line) + ", column " + std::to_string(name.column),
                 "bytes that are not UTF-8", "a name in UTF-8"});
        } else if (!seen.insert(name.text).second) {
            offences.push_back(table.offence(name, "each name once"));
        }
        columns.names.push_back(name);
    }
    if (columns.names.empty()) {
        offences.push_back(table.offence(head.line, columns.corner.text,
                                         "at least one name behind the first cell"));
    }

    // The numbers, in rows as long as the row of names.
    columns.cells.resize(columns.names.size());
    columns.values.resize(columns.names.size());
    for (std::size_t r = 1; r < rows.size(); ++r) {
        const CsvRow& row = rows[r];
        if (row.cells.size() != head.cells.size()) {
            offences.push_back(table.offence(row.line, std::to_string(row.cells.size()) + " cells",
                                             std::to_string(head.cells.size()) + " cells"));
            continue;
        }
        columns.axis.push_back(table.number(row.cells.front(), offences).value_or(0.0));
        columns.axisCells.push_back(row.cells.front());
        for (std::size_t i = 0; i < columns.names.size(); ++i) {
            const CsvCell& cell = row.cells[i + 1];
            columns.values[i].push_back(table.number(cell, offences).value_or(0.0));
            columns.cells[i].push_back(cell);
        }
    }
    return columns;
}

} // namespace irsg
