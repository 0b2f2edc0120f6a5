#pragma once

#include <filesystem>

#include "irsg/signature/ReflectanceTable.h"

namespace irsg {

/// Reads a table of reflectance: of our own form in CSV or, where its first words are of that
/// format, a Zemax tabular BSDF file. Our own has a row of names and then numbers: of
/// directional-hemispherical reflectance `incidence_deg` and the wavelengths in um,
///   incidence_deg,3.4,4.6
///   0,0.62,0.58
/// of a BRDF in sr-1 `incidence_deg`, `reflection_deg`, `azimuth_deg` (180: on the side of the
/// mirror direction) and the wavelengths, with a row for each combination of its angles. Throws
/// InputError naming file, line, column, value and what was expected.
ReflectanceTable readReflectanceTable(const std::filesystem::path& file);
/// Whether a file begins as such a table does; false where it cannot be read.
bool isReflectanceTable(const std::filesystem::path& file);
void writeReflectanceCsv(const ReflectanceTable& table, const std::filesystem::path& file);

/// Zemax's tabular BSDF format (Rykowski 2008, BSDF data interchange file format specification),
/// which scatterometers write and stray light programs read: BRDF of one wavelength that the file
/// does not name, over radial and azimuth angles about the mirror direction, brought to a grid of
/// 2.5 deg of reflection and azimuth. Measured on a plane of
/// symmetry, with one rotation of the sample.
ReflectanceTable parseZemaxBsdf(const std::string& text, const std::string& name);
bool isZemaxBsdf(const std::string& text);

} // namespace irsg
