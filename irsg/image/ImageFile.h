#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/image/ImageFormat.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

struct ComparisonOptions;

/// Reads an image by what the file holds, not by its name: one of imageFormats(). Of several parts
/// or pages `what` chooses. Throws InputError for what cannot be read; for a part or page of a
/// format without them; and by name for a file of another kind that is easily told (PNG, JPEG,
/// ...).
RadianceImage readImageFile(const std::filesystem::path& file, const ImageReading& what = {});

/// The images that a file holds, where it holds more than one, in their order; else empty. Throws
/// InputError for a file that cannot be read.
std::vector<ImagePart> imageParts(const std::filesystem::path& file);

/// Whether a file holds an image, told by its beginning (the first 256 KiB): OpenEXR, or text as
/// beginsAsCsvImage wants it. False for tables, other text, other formats, and what cannot be read;
/// true does not say that the rest is sound.
bool holdsImage(const std::filesystem::path& file);

/// The plane of that name. Without a name: the only one, else the first where it is known to be of
/// another quantity than radiance (PlaneQuantity.h), else `L`, else `Y` (luminance). Throws
/// InputError, naming `image` and listing its channels, where there is none such, or no telling.
const ImageChannel& chosenPlane(const RadianceImage& image, const std::string& channel,
                                const std::string& imageName);

/// The planes of two images that are compared: those of the names. Where one name is for both and
/// one of the images has no such plane, its usual one stands in, with a remark (R of an image of
/// colours with L of ours). Throws InputError as chosenPlane does, also where neither has it.
struct ComparedPlanes {
    const ImageChannel& a;
    const ImageChannel& b;
};
ComparedPlanes comparedPlanes(const RadianceImage& a, const RadianceImage& b,
                              const ComparisonOptions& options);

/// Names of the channels, "L, alpha, range_m".
std::string channelList(const RadianceImage& image);

} // namespace irsg
