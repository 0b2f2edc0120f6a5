#pragma once

#include <filesystem>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Writes a TIFF file: a page for each plane, 32-bit float samples (NaN and infinity bit for bit),
/// top row first, deflate with the floating point predictor of Technical Note 3. A page has the
/// name of its plane (PageName) and says it with its unit in ImageDescription, a line "key: value"
/// each; the first page's description goes on with the attributes of the image, written as by
/// writeCsvImage. Throws InputError where the file cannot be written; LogicError as writeExr.
void writeTiff(const RadianceImage& image, const std::filesystem::path& file);

/// Reads a TIFF file of ours or of another program: pages of one size, in strips or tiles, of one
/// or several samples a pixel, floats of 32 or 64 bits or integers of 8, 16 or 32 (the values
/// become floats as they are). A foreign page is called L where it is the first and has one sample,
/// else page2 or page1.1, page1.2, ...; its description is the attribute `description`. Throws
/// InputError for a file that is missing, damaged (with page and row) or truncated, for colours,
/// pages of different size, and for sizes beyond 32768 on a side or what the file could hold.
RadianceImage readTiff(const std::filesystem::path& file);

} // namespace irsg
