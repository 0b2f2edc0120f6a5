#pragma once

#include <filesystem>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// The header of an ENVI image: the file itself, where it begins as one, else FILE.hdr or the file
/// with .hdr in place of its extension, where that begins as one. Empty where there is none.
std::filesystem::path enviHeaderOf(const std::filesystem::path& file);

/// Reads an ENVI image by its header or by its data, which lie beside it under the same name with
/// another extension or none: interleave bsq, bil or bip, data types 1 to 5 and 12 to 15, either
/// byte order. Bands become planes: L where there is one, else by their names, or band1, band2, ...
/// Values equal to `data ignore value` are NaN, with a remark. Wavelengths of the bands and the
/// description become attributes. Throws InputError for a header that lacks a key, complex numbers,
/// and data of another size than the header says.
RadianceImage readEnvi(const std::filesystem::path& file);

} // namespace irsg
