#pragma once

#include <filesystem>
#include <vector>

#include "irsg/image/ImageFormat.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Largest side of an image that is read from a file, pixels.
inline constexpr int largestImageSide_px = 32768;

/// Writes an OpenEXR file: every channel as 32-bit float (NaN, infinity and denormals bit for bit),
/// scan lines, top row first, ZIP compression. Attributes are string attributes of the same name;
/// the unit of a channel is `unit.<channel>`, the order of the channels `channelOrder` (a file
/// keeps them sorted by name). The first channel is stored as `Y`, which other programs show as a
/// grey image, with its name in the attribute `plane.Y`, unless the image has channels called R, G,
/// B or Y. A name that OpenEXR uses itself (`compression`, `dataWindow`, ...) or that is one of
/// these gets `attribute.` in front, which readExr takes away again.
/// Throws InputError where the file cannot be written; LogicError for an empty image, a channel
/// whose size is not the image's, and an empty or repeated name.
void writeExr(const RadianceImage& image, const std::filesystem::path& file);

/// Reads an OpenEXR file of ours or of another program: scan lines or tiles, half, float or
/// unsigned channels. Of a file of several parts `what.part` chooses one by its name or number from
/// 1; else it is the one with `L`, else `Y`, else R, G and B, else the first, and a remark names
/// the others. The pixels are those of the data window. Channels of a foreign file come with `L`,
/// else `Y`, else the first by name, in front, and without units. String, number and string list
/// attributes become text; others (windows, previews, matrices) are left out. Throws InputError for
/// a file that is missing, is not OpenEXR, is truncated or damaged (with the row), holds deep or
/// subsampled data, has no such part, or is larger than 32768 on a side or 2^30 values in all.
/// Remarks on pixels that are not square.
RadianceImage readExr(const std::filesystem::path& file, const ImageReading& what = {});

/// The parts of an OpenEXR file. Throws InputError where it is none.
std::vector<ImagePart> exrParts(const std::filesystem::path& file);

} // namespace irsg
