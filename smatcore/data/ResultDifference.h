#pragma once

#include <string>

#include "smatcore/data/ResultTable.h"

namespace smat {

/// A result with the name that differences and refusals call it.
struct DifferenceSide {
    std::string name;
    const ResultTable* table = nullptr;
};

/// A minus B at every abscissa of either that both reach, each as it is drawn between its samples:
/// for each column that both measured in the same unit, `difference_<key>` in that unit and
/// `relative_difference_<key> [%]`, 100 (A - B) / |B|, without a value where B is 0. Angles of
/// polar plots repeat after 360 degrees. A missing sample of either leaves a gap (NaN). The
/// provenance names both sides, each with its own.
///
/// Throws InputError for abscissas of another quantity or unit, polar plots of another type, an
/// abscissa that turns back, results that do not overlap, and results without a common column.
ResultTable differenceOf(const DifferenceSide& a, const DifferenceSide& b);

/// True for the table of a plot whose cases followed its curves: between its rows it is an
/// AkimaInterpolant, not straight lines.
bool isAdaptive(const ResultTable& table);
/// Key of the abscissa of plots: wavelength of spectra, else the first column. LogicError for a
/// table without columns.
std::string abscissaKey(const ResultTable& table);
/// True for columns that say where a row was taken, not what was measured.
bool isAbscissa(const ResultTable& table, const ResultColumn& column);
/// How a polar plot was swept, "camera-azimuth", "camera-elevation" or "model-yaw", from the
/// provenance or else from its columns; "" for a table over no angle.
std::string polarTypeOf(const ResultTable& table);

} // namespace smat
