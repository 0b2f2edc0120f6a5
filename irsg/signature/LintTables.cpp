#include "irsg/signature/LintTables.h"

#include <cmath>

namespace irsg {

LookupTable withAxisChanged(const LookupTable& table, double factor, double offset) {
    std::vector<double> axis = table.x();
    for (double& position : axis)
        position = position * factor + offset;
    return {axis, table.y(), table.loop()};
}

void refuseLoop(const LintedTable& linted, Findings& findings) {
    if (!linted.table.loop())
        return;
    Finding& found = findings.error(linted.place, "a table in loop mode", "a loop over time alone");
    found.remedy = "switch the loop mode off";
    found.repair = linted.repairWith(
        [](const LookupTable& table) { return LookupTable(table.x(), table.y()); });
}

void lintLoop(const LintedTable& linted, Findings& findings) {
    const LookupTable& table = linted.table;
    if (!table.loop())
        return;
    const auto& values = table.y();
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    if (std::abs(values.back() - values.front()) <= 1e-9 * largest)
        return;
    Finding& found = findings.warning(
        linted.place,
        "a jump from " + numberText(values.back()) + " to " + numberText(values.front()) +
            " at each turn",
        "a last value equal to the first: the last node is the first of the next turn");
    found.remedy = "add a last node with the first value, one step later";
    found.repair = linted.repairWith([](const LookupTable& open) {
        std::vector<double> axis = open.x();
        std::vector<double> closed = open.y();
        axis.push_back(2.0 * axis.back() - axis[axis.size() - 2]);
        closed.push_back(closed.front());
        return LookupTable(axis, closed, true);
    });
}

void suspectAxis(const LintedTable& linted, const AxisSuspicion& suspicion, Findings& findings) {
    const auto& axis = linted.table.x();
    if (axis.size() < 2 || axis.back() < suspicion.low || axis.back() > suspicion.high ||
        suspicion.low >= suspicion.high) {
        return;
    }
    Finding& found = findings.warning(
        linted.place, "an axis from " + numberText(axis.front()) + " to " + numberText(axis.back()),
        suspicion.expected);
    found.remedy = suspicion.remedy;
    found.repair = linted.repairWith(
        [factor = suspicion.factor, offset = suspicion.offset](const LookupTable& table) {
            return withAxisChanged(table, factor, offset);
        });
}

} // namespace irsg
