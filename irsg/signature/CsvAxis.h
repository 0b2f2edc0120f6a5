#pragma once

#include <vector>

#include "irsg/radiometry/SpectralHead.h"
#include "irsg/signature/CsvColumns.h"

namespace irsg {

/// Reads cell (0,0) as spectralHead() does; a wavelength without a unit is what its values tell,
/// with a remark. Everything else is a diagnostic, unless the row of names is missing and said to
/// be.
SpectralAxis readSpectralAxis(const CsvTable& table, const CsvColumns& columns,
                              std::vector<Diagnostic>& diagnostics);

/// An axis must be positive, and strictly monotonic in the direction of its first two nodes.
void checkSpectralAxis(const CsvTable& table, const CsvColumns& columns,
                       std::vector<Diagnostic>& diagnostics);

/// The axis in um, in the order of the file.
std::vector<double> wavelengthsOf(const CsvColumns& columns, SpectralAxis axis);

/// A name as a cell: in quotes where it holds what separates cells.
std::string csvCell(const std::string& name);

} // namespace irsg
