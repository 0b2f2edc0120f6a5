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
/// three, the sum must close to 1e-4. `n` and `k` of the bulk, `diffuse_reflectivity` and
/// `volume_reflectivity` may stand beside them or alone: then those three stay. The CSV of
/// refractiveindex.info (`wl,n` and `wl,k`, over um) is read as well. Name and N of `material`
/// stay; after an error all of it does.
/// Throws InputError naming file, line, column, value and what was expected, all at once.
void readMaterialCsv(const std::filesystem::path& file, Material& material);

/// What an import of such a file makes of the entry of an index: one that is there keeps what the
/// file does not hold (its N, its notes, its name where none is given); a new one is named as the
/// file where no name is given. Throws as readMaterialCsv does.
Material importedMaterial(const std::filesystem::path& file, const SignatureDatabase& database,
                          int index, const std::string& name = "");

/// The same of a table of reflectance (see readReflectanceTable): the model is then "tabulated",
/// and the emissivity what the table leaves along the normal.
Material importedReflectance(const std::filesystem::path& file, const SignatureDatabase& database,
                             int index, const std::string& name = "");

/// Writes emissivity, transmissivity and reflectivity over the merged axis in um; a grey material
/// gets one row at either end of 0.3 to 30 um. What it has of n, k, diffuse and volume reflectivity
/// stands behind them. Throws InputError where the file cannot be written.
void writeMaterialCsv(const Material& material, const std::filesystem::path& file);

} // namespace irsg
