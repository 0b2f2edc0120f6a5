#pragma once

#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/gas/PlumeField.h"

namespace irsg {

/// The gas at a place, as computations of flows in three dimensions give it.
struct PlumePoint {
    GasVector place_m{};
    PlumeField::Node gas;
    int line = 0; ///< of its file
};

/// Whether the head of a table has y or z, as points in space have.
bool arePlumePoints(const CsvTable& csv);
/// Columns by name: `x [m]`, `y [m]`, `z [m]`, `T [K]`, and those of the gas that a table about an
/// axis may have (PlumeTable::read). Points in any order. Throws InputError with every diagnostic
/// by file, line and column, and for points that a field cannot be made of (fieldOfPoints).
PlumeField readPlumePoints(const CsvTable& csv);

/// Points that are all nodes of planes across the axes are those of the field. Of others the field
/// follows by linear functions fitted to the 16 nearest, which meet each of them (P. Lancaster and
/// K. Salkauskas 1981, Math. Comp. 37, 141), at up to 300,000 nodes whose planes lie closer where
/// points that absorb do; never beyond the values of those 16. What is farther from all points than
/// one and a quarter of their distances is no gas. `name` stands for them in diagnostics.
/// InputError for fewer than 8, for points in one plane across an axis, and for two states at one
/// place.
PlumeField fieldOfPoints(std::vector<PlumePoint> points, const std::string& name);

} // namespace irsg
