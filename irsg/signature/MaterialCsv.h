#pragma once

#include <filesystem>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// emissivity + reflectivity + transmissivity may miss 1 by this much where all three are given.
inline constexpr double closureTolerance = 1e-4;

/// Reads the spectra of a material: cell (0,0) a head of spectralHead(), row 0 any of `emissivity`,
/// `transmissivity` and `reflectivity` (also as emittance, transmittance, reflectance, and in
/// percent where the head has %), column 0 the shared axis, ascending or descending but strictly
/// monotonic. What is not given follows from the sum of 1; with reflectivity alone or emissivity
/// alone the material is opaque; with transmissivity alone it does not reflect. With all three, the
/// sum must close to 1e-4. Values up to 0.005 outside of 0 to 1 become the bound, with a remark.
/// `n` and `k` of the bulk, `diffuse_reflectivity` and `volume_reflectivity` may stand beside them
/// or alone: then those three stay. The CSV of refractiveindex.info (`wl,n` and `wl,k`, over um)
/// and the files of readSpectralLibrary() are read as well. Name and N of `material` stay; after an
/// error all of it does. Throws InputError naming file, line, column, value and what was expected,
/// all at once.
void readMaterialCsv(const std::filesystem::path& file, Material& material);

/// What an import of such a file makes of the entry of an index: one that is there keeps what the
/// file does not hold (its N, its notes, its name where none is given); a new one is named as the
/// file where no name is given. Where the file holds n and k alone and the entry is a black body
/// without a surface model, its emissivity becomes that of a flat face along the normal. Throws as
/// readMaterialCsv does.
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
