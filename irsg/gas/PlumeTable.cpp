#include "irsg/gas/PlumeTable.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

/// A column that a table may have.
struct PlumeColumn {
    const char* name; ///< without its unit
    const char* unit;
    bool isNeeded;
    double& (*of)(GasLayer&); ///< null for a place
};

const std::vector<PlumeColumn>& plumeColumns() {
    static const std::vector<PlumeColumn> all = {
        {"x", "m", true, nullptr},
        {"r", "m", true, nullptr},
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

std::string plumeHeadOf(const PlumeColumn& column) {
    return std::string(column.name) +
           (*column.unit != '\0' ? " [" + std::string(column.unit) + "]" : "");
}

struct PlumeRow {
    double x_m = 0.0, r_m = 0.0;
    GasLayer gas;
    int line = 0;
};

/// Which column each cell of the head is.
std::vector<const PlumeColumn*> readPlumeHead(const CsvTable& csv,
                                              std::vector<Diagnostic>& diagnostics) {
    std::vector<const PlumeColumn*> found;
    std::string expected;
    for (const PlumeColumn& column : plumeColumns())
        expected += (expected.empty() ? "" : ", ") + plumeHeadOf(column);
    for (const CsvCell& cell : csv.rows().front().cells) {
        const auto column =
            std::ranges::find(plumeColumns(), columnHead(cell.text),
                              [](const PlumeColumn& one) { return columnHead(plumeHeadOf(one)); });
        const bool isKnown = column != plumeColumns().end();
        if (!isKnown)
            diagnostics.push_back(csv.diagnostic(cell, "one of " + expected));
        else if (std::ranges::find(found, &*column) != found.end())
            diagnostics.push_back(csv.diagnostic(cell, "each column once"));
        found.push_back(isKnown ? &*column : nullptr);
    }
    for (const PlumeColumn& column : plumeColumns())
        if (column.isNeeded && std::ranges::find(found, &column) == found.end())
            diagnostics.push_back(csv.diagnostic("no column " + plumeHeadOf(column), expected));
    return found;
}

PlumeRow readPlumeRow(const CsvTable& csv, const CsvRow& cells,
                      const std::vector<const PlumeColumn*>& head,
                      std::vector<Diagnostic>& diagnostics) {
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
        if (head[i]->of)
            head[i]->of(row.gas) = *number;
        else
            (*head[i]->name == 'x' ? row.x_m : row.r_m) = *number;
    }
    if (diagnostics.size() != before)
        return row;
    GasLayer any = row.gas;
    any.length_m = 1.0;
    for (const Diagnostic& one : gasLayerDiagnostics(any, ""))
        diagnostics.push_back(
            csv.diagnostic(row.line, one.position + " = " + one.value, one.expected));
    if (row.r_m < 0.0)
        diagnostics.push_back(
            csv.diagnostic(row.line, "r = " + numberText(row.r_m), "a distance of at least 0 m"));
    return row;
}

std::vector<double> distinct(const std::vector<PlumeRow>& rows, double PlumeRow::*of) {
    std::set<double> values;
    for (const PlumeRow& row : rows)
        values.insert(row.*of);
    return {values.begin(), values.end()};
}

} // namespace

PlumeTable PlumeTable::read(const std::filesystem::path& file) {
    const CsvTable csv = CsvTable::read(file);
    std::vector<Diagnostic> diagnostics;
    const auto check = [&] {
        if (!diagnostics.empty())
            throw InputError(std::move(diagnostics));
    };
    if (csv.rows().size() < 2)
        diagnostics.push_back(csv.diagnostic("no rows", "a head and the nodes of a plume"));
    check();
    const std::vector<const PlumeColumn*> head = readPlumeHead(csv, diagnostics);
    check();
    std::vector<PlumeRow> rows;
    for (std::size_t i = 1; i < csv.rows().size(); ++i)
        rows.push_back(readPlumeRow(csv, csv.rows()[i], head, diagnostics));
    check();
    PlumeTable table;
    table.x_m_ = distinct(rows, &PlumeRow::x_m);
    table.r_m_ = distinct(rows, &PlumeRow::r_m);
    if (table.x_m_.size() < 2 || table.r_m_.size() < 2 || table.r_m_.front() != 0.0)
        diagnostics.push_back(csv.diagnostic(std::to_string(table.x_m_.size()) + " x and " +
                                                 std::to_string(table.r_m_.size()) + " r from " +
                                                 numberText(table.r_m_.front()) + " m",
                                             "two of each at least, r from 0"));
    check();
    table.nodes_.resize(table.x_m_.size() * table.r_m_.size());
    std::vector<bool> isThere(table.nodes_.size());
    for (const PlumeRow& row : rows) {
        const auto x = std::ranges::lower_bound(table.x_m_, row.x_m) - table.x_m_.begin();
        const auto r = std::ranges::lower_bound(table.r_m_, row.r_m) - table.r_m_.begin();
        const std::size_t at =
            static_cast<std::size_t>(x) * table.r_m_.size() + static_cast<std::size_t>(r);
        if (isThere[at])
            diagnostics.push_back(csv.diagnostic(
                row.line, "x = " + numberText(row.x_m) + ", r = " + numberText(row.r_m) + " again",
                "each place once"));
        isThere[at] = true;
        table.nodes_[at] = row.gas;
    }
    const auto missing = std::ranges::find(isThere, false);
    if (diagnostics.empty() && missing != isThere.end()) {
        const auto at = static_cast<std::size_t>(missing - isThere.begin());
        diagnostics.push_back(
            csv.diagnostic("no row of x = " + numberText(table.x_m_[at / table.r_m_.size()]) +
                               ", r = " + numberText(table.r_m_[at % table.r_m_.size()]),
                           "every x with every r"));
    }
    check();
    return table;
}

PlumeTable PlumeTable::ofNodes(std::vector<double> x_m, std::vector<double> r_m,
                               std::vector<GasLayer> nodes) {
    if (nodes.size() != x_m.size() * r_m.size())
        throw LogicError("a plume has not one node for each x and r");
    PlumeTable table;
    table.x_m_ = std::move(x_m);
    table.r_m_ = std::move(r_m);
    table.nodes_ = std::move(nodes);
    return table;
}

GasLayer PlumeTable::at(double x_m, double r_m) const {
    const Bracket x = bracket(x_m_, x_m), r = bracket(r_m_, r_m);
    GasLayer gas;
    for (const PlumeColumn& column : plumeColumns()) {
        if (!column.of)
            continue;
        const auto of = [&](std::size_t i, std::size_t j) {
            GasLayer copy = node(i, j);
            return column.of(copy);
        };
        column.of(gas) =
            lerp(lerp(of(x.below, r.below), of(x.below, r.above), r.fraction),
                 lerp(of(x.above, r.below), of(x.above, r.above), r.fraction), x.fraction);
    }
    return gas;
}

} // namespace irsg
