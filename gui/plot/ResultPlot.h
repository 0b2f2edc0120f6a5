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
    bool isAlone = true; ///< on its plot: what its curves differ in names them
};

/// True for a table over an angle: it belongs on a polar plot.
bool isPolar(const ResultTable& table);

/// What can be drawn against the abscissa, the one most asked for first: keys of columns, and of
/// columns that differ in object or band alone their series (ColumnName), once. Throws InputError
/// for a table without rows or without such a column.
std::vector<std::string> plottableQuantities(const ResultTable& table);

/// "Contrast intensity (W·sr⁻¹)" of one of plottableQuantities().
QString quantityTitle(const ResultTable& table, const std::string& quantity);

/// Whether both can be overlaid as they are shown at first: the same abscissa or type of sweep, and
/// the quantity that is most asked for.
bool goOnOnePlot(const ResultTable& a, const ResultTable& b);

/// Whether a quantity of a result can be drawn as a stack of what its parts add, or its objects
/// where it has no parts: in one band and over one turn.
bool canStack(const ResultTable& table, const std::string& quantity);

/// Overlays one quantity of several results; a series gives a curve for each object and band, named
/// by them and its result, and several turns of a polar plot one for each elevation. All must have
/// it and share the abscissa, and on polar plots the type of sweep (InputError). At least one
/// result (LogicError). `stacked`, of one result that can be: a layer for each part that adds
/// anything, the largest first, what is above 0 upwards and what is below downwards, and the sum as
/// a line.
PlotData cartesianData(const std::vector<NamedResult>& results, const std::string& quantity,
                       bool stacked = false);
PolarData polarData(const std::vector<NamedResult>& results, const std::string& quantity,
                    bool stacked = false);

} // namespace smat::gui
