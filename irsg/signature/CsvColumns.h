#pragma once

#include <string>
#include <vector>

#include "irsg/core/CsvTable.h"

namespace irsg {

/// What tables 18 to 20 of the report have in common: a row of names, an axis in the first column
/// and a column of numbers under each name.
struct CsvColumns {
    CsvCell corner;             ///< cell (0,0)
    std::vector<CsvCell> names; ///< not empty, each name once
    std::vector<double> axis;   ///< finite
    std::vector<CsvCell> axisCells;
    std::vector<std::vector<CsvCell>> cells; ///< one list a name, as long as the axis
    std::vector<std::vector<double>> values; ///< the same as finite numbers
};

/// Takes the columns out of a table with at least `fewestNodes` rows under the names. Diagnostics
/// are added to `diagnostics`; the result is complete only where none were.
CsvColumns readColumns(const CsvTable& table, std::size_t fewestNodes,
                       std::vector<Diagnostic>& diagnostics);

} // namespace irsg
