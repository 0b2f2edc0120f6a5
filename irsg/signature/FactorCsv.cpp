#include <algorithm>
#include <utility>

#include "irsg/core/ColumnWords.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/CsvColumns.h"
#include "irsg/signature/SpectrumCsv.h"

namespace irsg {

namespace {

void checkNames(const CsvTable& table, const CsvColumns& columns, const UserSpectrum& spectrum,
                std::vector<Diagnostic>& diagnostics) {
    std::string known;
    for (const SpectrumComponent& component : spectrum.components)
        known += (known.empty() ? "" : ", ") + component.name;
    for (const CsvCell& name : columns.names) {
        if (!name.text.empty() && spectrum.find(name.text) == nullptr) {
            diagnostics.push_back(table.diagnostic(name, "a component of the spectrum '" +
                                                             spectrum.name + "': " + known));
        }
    }
}

/// The first cell is empty or names the axis.
void checkCorner(const CsvTable& table, const CsvCell& corner, FactorAxis axis,
                 std::vector<Diagnostic>& diagnostics) {
    const ColumnHead head = columnHead(corner.text);
    const ColumnHead own = columnHead(axis == FactorAxis::time_s ? "time [s]" : "angle [deg]");
    if (!corner.text.empty() &&
        (head.name != own.name || !(head.unit.empty() || head.unit == own.unit)))
        diagnostics.push_back(table.diagnostic(
            corner, std::string("an empty first cell, or '") +
                        (axis == FactorAxis::time_s ? "time [s]" : "angle [deg]") + "'"));
}

void checkNumbers(const CsvTable& table, const CsvColumns& columns, FactorAxis axis,
                  std::vector<Diagnostic>& diagnostics) {
    for (std::size_t i = 0; i < columns.axis.size(); ++i) {
        const double position = columns.axis[i];
        if (axis == FactorAxis::angle_deg && (position < 0.0 || position > 180.0)) {
            diagnostics.push_back(
                table.diagnostic(columns.axisCells[i], "an angle from 0 to 180 degrees"));
        }
        if (i > 0 && position <= columns.axis[i - 1]) {
            diagnostics.push_back(
                table.diagnostic(columns.axisCells[i], "a strictly ascending axis: a value above " +
                                                           columns.axisCells[i - 1].text));
        }
        for (std::size_t c = 0; c < columns.names.size(); ++c) {
            if (columns.values[c][i] < 0.0) {
                diagnostics.push_back(
                    table.diagnostic(columns.cells[c][i], "a factor of at least 0"));
            }
        }
    }
}

ComponentFactor& factorOf(ComponentFactors& factors, const std::string& component) {
    const auto found = std::ranges::find(factors, component, &ComponentFactor::component);
    if (found != factors.end())
        return *found;
    factors.push_back({component, 1.0, {}, {}});
    return factors.back();
}

} // namespace

void readFactorCsv(const std::filesystem::path& file, FactorAxis axis, bool loop,
                   const UserSpectrum& spectrum, ComponentFactors& into) {
    const CsvTable table = CsvTable::read(file);
    std::vector<Diagnostic> diagnostics;
    if (loop && axis == FactorAxis::angle_deg) {
        diagnostics.push_back(
            table.diagnostic("loop mode over angle", "loop mode over time alone"));
    }
    const CsvColumns columns = readColumns(table, loop ? 2 : 1, diagnostics);
    checkCorner(table, columns.corner, axis, diagnostics);
    checkNames(table, columns, spectrum, diagnostics);
    if (diagnostics.empty())
        checkNumbers(table, columns, axis, diagnostics);
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        ComponentFactor& factor = factorOf(into, columns.names[i].text);
        LookupTable& to = axis == FactorAxis::time_s ? factor.time : factor.angle;
        to = LookupTable(columns.axis, columns.values[i], loop, factor.component);
    }
}

} // namespace irsg
