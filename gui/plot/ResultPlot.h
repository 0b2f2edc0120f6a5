#pragma once

#include <string>
#include <vector>

#include "gui/plot/PlotData.h"
#include "smatcore/data/ResultTable.h"

namespace smat::gui {

/// A result with the name its curve gets.
struct NamedResult {
    QString name;
    const ResultTable* table = nullptr;
};

/// True for a table over an angle: it belongs on a polar plot.
bool isPolar(const ResultTable& table);

/// Keys of the columns that can be drawn against the abscissa, the one most asked for first.
/// Throws InputError for a table without rows or without such a column.
std::vector<std::string> plottableQuantities(const ResultTable& table);

/// Whether both can be overlaid as they are shown at first: the same abscissa or type of sweep, and
/// the quantity that is most asked for.
bool goOnOnePlot(const ResultTable& a, const ResultTable& b);

/// Overlays one quantity of several results. All must have it and share the abscissa, and on polar
/// plots the type of sweep (InputError). At least one result (LogicError).
PlotData cartesianData(const std::vector<NamedResult>& results, const std::string& quantity);
PolarData polarData(const std::vector<NamedResult>& results, const std::string& quantity);

} // namespace smat::gui
