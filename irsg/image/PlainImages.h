#pragma once

#include <filesystem>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Reads an ESRI ASCII grid: `ncols`, `nrows` and further keys with a number each, then the values
/// between blanks, top row first. Decimal commas are read as CSV does. NODATA_value becomes NaN,
/// with a remark; corners and cell size become attributes. Throws InputError naming the line for a
/// missing size, a word that is no number, and too few or too many values.
RadianceImage readEsriGrid(const std::filesystem::path& file);

/// Reads a portable float map: Pf (one plane, L) or PF (R, G, B), bottom row first, whose scale is
/// negative where the numbers are little-endian. A scale other than 1 does not change the values,
/// with a remark. Throws InputError for a damaged header and another size than it says.
RadianceImage readPfm(const std::filesystem::path& file);

/// Reads an array of NumPy (.npy, versions 1 to 3) of two dimensions, rows first: floats of 16, 32
/// or 64 bits or integers, either byte order, in the order of C or Fortran. Further dimensions of 1
/// do not count. Throws InputError for other shapes and types.
RadianceImage readNpy(const std::filesystem::path& file);

} // namespace irsg
