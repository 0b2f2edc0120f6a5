#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "smatcore/data/ResultTable.h"

namespace smat {

/// Columns that tell the rows of a table apart: its abscissa first, then those of isAbscissa() that
/// differ among rows which agree in the columns before. Empty for a table without columns.
std::vector<const ResultColumn*> axesOf(const ResultTable& table);

/// The place of a row on these axes: "30 deg", of several "azimuth 30 deg, elevation 5 deg", with
/// six digits.
std::string rowPlace(const std::vector<const ResultColumn*>& axes, std::size_t row);
/// "azimuth 30 deg": with the axis, or "30 deg" without.
std::string axisPlace(const ResultColumn& axis, double value, bool isNamed);

} // namespace smat
