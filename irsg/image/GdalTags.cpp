#include "irsg/image/GdalTags.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

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

/// What stands for a sample in place of its stored values.
struct Calibration {
    std::optional<double> scale, offset;
    std::string unit;
};

/// The number of a sample, from 0; none where it is none of so many.
std::optional<std::size_t> sampleOf(const std::string& text, std::size_t samples) {
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc() && read.ptr == end && number < samples ? std::optional(number)
                                                                         : std::nullopt;
}

/// Those that the metadata of a page state for so many samples; what they state in vain goes to
/// `complain`.
template <typename Complain>
std::vector<Calibration> calibrationsOf(const std::string& metadata, std::size_t samples,
                                        const Complain& complain) {
    std::vector<Calibration> all(samples);
    pugi::xml_document document;
    if (!document.load_buffer(metadata.data(), metadata.size())) {
        complain("GDAL_METADATA is no sound XML");
        return all;
    }
    for (const pugi::xml_node item : document.child("GDALMetadata").children("Item")) {
        const std::string role = item.attribute("role").value(),
                          sample = item.attribute("sample").value(),
                          text(trimmed(item.text().get()));
        if (role != "scale" && role != "offset" && role != "unittype")
            continue;
        const auto number = sampleOf(sample, samples);
        if (!number) {
            complain("the " + role + " of sample '" + sample.substr(0, 40) +
                     "' in GDAL_METADATA, which is not there,");
            continue;
        }
        Calibration& of = all[*number];
        if (role == "unittype") {
            of.unit = text;
            continue;
        }
        const auto value = parseNumber(text);
        if (!value || !std::isfinite(*value) || (role == "scale" && *value == 0.0))
            complain("the " + role + " '" + text.substr(0, 40) + "' of GDAL_METADATA");
        else
            (role == "scale" ? of.scale : of.offset) = *value;
    }
    return all;
}

/// Applies them to the planes of a page.
void takeMetadata(const std::string& metadata, RadianceImage& image, std::size_t firstPlane,
                  const std::string& file, const std::string& page) {
    if (metadata.empty())
        return;
    const auto all =
        calibrationsOf(metadata, image.channels.size() - firstPlane, [&](const std::string& what) {
            remarkOn(file, page + ": " + what + " is left out; values are as stored");
        });
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImageChannel& plane = image.channels[firstPlane + i];
        const Calibration& of = all[i];
        const std::string sample = page + ", sample " + std::to_string(i + 1) + ": ";
        if (plane.unit.empty() && !of.unit.empty()) {
            plane.unit = of.unit;
            remarkOn(file, sample + "the unit " + of.unit + " is that of GDAL_METADATA");
        }
        const double scale = of.scale.value_or(1.0), offset = of.offset.value_or(0.0);
        if (scale == 1.0 && offset == 0.0)
            continue;
        for (float& value : plane.values)
            value = static_cast<float>(scale * static_cast<double>(value) + offset);
        remarkOn(file, sample + "scale " + roundedText(scale, 9) + " and offset " +
                           roundedText(offset, 9) + " of GDAL_METADATA are applied");
    }
}

/// Values that stand for none.
void takeMissing(const std::string& text, RadianceImage& image, std::size_t firstPlane,
                 const std::string& file, const std::string& page) {
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

} // namespace

void takeGdalTags(TIFF* tiff, RadianceImage& image, std::size_t firstPlane, const std::string& file,
                  const std::string& page) {
    // Missing values are those that are stored.
    takeMissing(textOf(tiff, missingTag), image, firstPlane, file, page);
    takeMetadata(textOf(tiff, metadataTag), image, firstPlane, file, page);
}

} // namespace irsg
