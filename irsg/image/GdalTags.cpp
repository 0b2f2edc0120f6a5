#include "irsg/image/GdalTags.h"

#include <cstdint>
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

GdalTags gdalTagsOf(TIFF* tiff, const std::string& file, const std::string& page) {
    GdalTags tags;
    const std::string metadata = textOf(tiff, metadataTag);
    tags.hasScale = metadata.find("role=\"scale\"") != std::string::npos ||
                    metadata.find("role=\"offset\"") != std::string::npos;
    const std::string missing = textOf(tiff, missingTag);
    tags.missing = parseNumber(missing);
    if (!tags.missing && !missing.empty() && lowerCase(missing) != "nan")
        remarkOn(file, page + ": GDAL_NODATA '" + missing.substr(0, 40) +
                           "' is no number and is left out");
    return tags;
}

} // namespace irsg
