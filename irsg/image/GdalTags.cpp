#include "irsg/image/GdalTags.h"

#include <cstdint>
#include <limits>
#include <string_view>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

constexpr std::uint32_t metadataTag = 42112, missingTag = 42113;

/// The text of a tag that libtiff does not know, which it hands on with the count of its bytes; ""
/// where the page has no such text.
std::string textOf(TIFF* tiff, std::uint32_t tag) {
    const TIFFField* const field = TIFFFindField(tiff, tag, TIFF_ANY);
    if (field == nullptr || TIFFFieldDataType(field) != TIFF_ASCII || !TIFFFieldPassCount(field))
        return "";
    std::uint32_t count = 0;
    const char* bytes = nullptr;
    if (TIFFGetField(tiff, tag, &count, &bytes) != 1 || bytes == nullptr)
        return "";
    const std::string_view text(bytes, count);
    return std::string(trimmed(text.substr(0, text.find('\0'))));
}

} // namespace

void takeGdalTags(TIFF* tiff, RadianceImage& image, std::size_t firstPlane, const std::string& file,
                  const std::string& page) {
    const std::string metadata = textOf(tiff, metadataTag);
    if (metadata.find("role=\"scale\"") != std::string::npos ||
        metadata.find("role=\"offset\"") != std::string::npos)
        remarkOn(file, page + ": scale and offset of GDAL_METADATA are left out; values are as "
                              "stored");
    const std::string text = textOf(tiff, missingTag);
    const auto stored = parseNumber(text);
    if (!stored && !text.empty() && lowerCase(text) != "nan")
        remarkOn(file,
                 page + ": GDAL_NODATA '" + text.substr(0, 40) + "' is no number and is left out");
    if (!stored)
        return;
    const auto missing = static_cast<float>(*stored);
    std::size_t count = 0;
    for (std::size_t i = firstPlane; i < image.channels.size(); ++i)
        for (float& value : image.channels[i].values)
            if (value == missing) {
                value = std::numeric_limits<float>::quiet_NaN();
                ++count;
            }
    if (count > 0)
        remarkOn(file, page + ": " + std::to_string(count) +
                           " values are GDAL_NODATA and are read as NaN");
}

} // namespace irsg
