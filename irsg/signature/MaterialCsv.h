#pragma once

#include <filesystem>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// emissivity + reflectivity + transmissivity may miss 1 by this much where all three are given.
inline constexpr double closureTolerance = 1e-4;

/// Reads the spectra of a material: cell (0,0) `um` or `cm-1`, row 0 any of `emissivity`,
/// `transmissivity` and `reflectivity`, column 0 the shared axis, ascending or descending but
/// strictly monotonic. What is not given follows from the sum of 1; with reflectivity alone or
/// emissivity alone the material is opaque; with transmissivity alone it does not reflect. With all
/// three, the sum must close to 1e-4. Name and N of `material` stay; after an error all of it does.
/// Throws InputError naming file, line, column, value and what was expected, all at once.
void readMaterialCsv(const std::filesystem::path& file, Material& material);

/// Writes emissivity, transmissivity and reflectivity over the merged axis in um; a grey material
/// gets one row at either end of 0.3 to 30 um. Throws InputError where the file cannot be written.
void writeMaterialCsv(const Material& material, const std::filesystem::path& file);

} // namespace irsg
