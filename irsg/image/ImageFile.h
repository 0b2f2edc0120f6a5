#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Reads an image by what the file holds, not by its name: OpenEXR (ours, or any other with
/// channels of half, float or unsigned integers, and any data window), or text: CSV of ours and
/// plain matrices (SMAT and KARMA), see readExr and readCsvImage. Throws their InputErrors; a file
/// of another kind that is easily told (PNG, JPEG, TIFF, ...) is refused by name.
RadianceImage readImageFile(const std::filesystem::path& file);

/// Whether a file holds an image, told by its beginning (the first 256 KiB): OpenEXR, or text as
/// beginsAsCsvImage wants it. False for tables, other text, other formats, and what cannot be read;
/// true does not say that the rest is sound.
bool holdsImage(const std::filesystem::path& file);

/// The plane of that name. Without a name: the only one, else `L`, else `Y` (luminance). Throws
/// InputError, naming `image` and listing its channels, where there is none such, or no telling.
const ImageChannel& chosenPlane(const RadianceImage& image, const std::string& channel,
                                const std::string& imageName);

/// Names of the channels, "L, alpha, range_m".
std::string channelList(const RadianceImage& image);

} // namespace irsg
