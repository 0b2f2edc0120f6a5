#include "irsg/gas/PlumeTable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/gas/PlumeColumns.h"

namespace irsg {

namespace {

std::vector<double> distinct(const std::vector<PlumeRow>& rows, std::size_t place) {
    std::set<double> values;
    for (const PlumeRow& row : rows)
        values.insert(row.place_m[place]);
    return {values.begin(), values.end()};
}

} // namespace

PlumeTable PlumeTable::read(const std::filesystem::path& file) {
    return of(CsvTable::read(file));
}

PlumeTable PlumeTable::of(const CsvTable& csv) {
    std::vector<PlumeRow> rows;
    readPlumeRows(
        csv, {"x", "r"}, [&](const PlumeRow& row) { rows.push_back(row); },
        [&](const PlumeRow& row) {
            std::vector<Diagnostic> wrong;
            if (const double r_m = row.place_m[1]; r_m < 0.0)
                wrong.push_back(csv.diagnostic(row.line, "r = " + numberText(r_m),
                                               "a distance of at least 0 m"));
            return wrong;
        });
    std::vector<Diagnostic> diagnostics;
    const auto check = [&] {
        if (!diagnostics.empty())
            throw InputError(std::move(diagnostics));
    };
    PlumeTable table;
    table.x_m_ = distinct(rows, 0);
    table.r_m_ = distinct(rows, 1);
    if (table.x_m_.size() < 2 || table.r_m_.size() < 2 || table.r_m_.front() != 0.0)
        diagnostics.push_back(csv.diagnostic(std::to_string(table.x_m_.size()) + " x and " +
                                                 std::to_string(table.r_m_.size()) + " r from " +
                                                 numberText(table.r_m_.front()) + " m",
                                             "two of each at least, r from 0"));
    check();
    table.nodes_.resize(table.x_m_.size() * table.r_m_.size());
    std::vector<bool> isThere(table.nodes_.size());
    for (const PlumeRow& row : rows) {
        const auto [x_m, r_m, none] = row.place_m;
        const auto x = std::ranges::lower_bound(table.x_m_, x_m) - table.x_m_.begin();
        const auto r = std::ranges::lower_bound(table.r_m_, r_m) - table.r_m_.begin();
        const std::size_t at =
            static_cast<std::size_t>(x) * table.r_m_.size() + static_cast<std::size_t>(r);
        if (isThere[at])
            diagnostics.push_back(csv.diagnostic(
                row.line, "x = " + numberText(x_m) + ", r = " + numberText(r_m) + " again",
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
    for (const PlumeColumn& column : plumeGasColumns()) {
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
