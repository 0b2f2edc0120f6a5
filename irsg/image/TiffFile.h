#pragma once

#include <filesystem>
#include <vector>

#include "irsg/image/ImageFormat.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Writes a TIFF file: a page for each plane, 32-bit float samples (NaN and infinity bit for bit),
/// top row first, deflate with the floating point predictor of Technical Note 3. A page has the
/// name of its plane (PageName) and says it with its unit in ImageDescription, a line "key: value"
/// each; the first page's description goes on with the attributes of the image, written as by
/// writeCsvImage. Throws InputError where the file cannot be written; LogicError as writeExr.
void writeTiff(const RadianceImage& image, const std::filesystem::path& file);

/// Reads a TIFF file of ours or of another program: pages in strips or tiles, of one or several
/// samples a pixel, floats of 16, 32 or 64 bits or integers of 8, 16 or 32 (the values become
/// floats as they are), mirrored or turned by half where their orientation says so. Pages as large
/// as the first make one image; a remark names those that are left out (of another size, reduced
/// copies, masks), and what else there is beside the first page. `what.page` chooses one page
/// alone. A foreign page is called L where it is the first and has one sample, R, G, B where it
/// holds floats of three colours, else page2 or page1.1, page1.2, ...; its description is the
/// attribute `description`. Throws InputError for a file that is missing, damaged (with page and
/// row) or truncated, for colours of integers, and for sizes beyond 32768 on a side or what the
/// file could hold.
RadianceImage readTiff(const std::filesystem::path& file, const ImageReading& what = {});

/// The pages of a TIFF file. Throws InputError where it is none.
std::vector<ImagePart> tiffPages(const std::filesystem::path& file);

} // namespace irsg
