#include "irsg/image/ImageFile.h"

#include <string_view>
#include <vector>

#include "irsg/core/BinaryFormats.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Wording.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/EnviFile.h"
#include "irsg/image/ImageComparison.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/PlaneQuantity.h"

namespace irsg {

namespace {

constexpr std::size_t beginningSize = std::size_t{256} << 10;

/// The format of a file: by its beginning, or by the ENVI header beside it.
const ImageFormat* formatOf(const std::filesystem::path& file, std::string_view beginning) {
    const std::vector<const ImageFormat*> all = readImageFormats();
    for (const ImageFormat* format : all)
        if (!format->isText && format->recognises(beginning))
            return format;
    for (const std::string_view text : {beginning, std::string_view("ENVI")})
        if (text == beginning || !enviHeaderOf(file).empty())
            for (const ImageFormat* format : all)
                if (format->isText && format->recognises(text))
                    return format;
    return nullptr;
}

/// "OpenEXR image, TIFF image or values as text".
std::string namesOfReadFormats() {
    std::vector<std::string> names;
    for (const ImageFormat* format : imageFormats())
        if (format->read != nullptr)
            names.emplace_back(format->name);
    for (const ImageFormat* format : foreignImageFormats())
        names.emplace_back(format->name);
    return alternatives(names);
}

} // namespace

RadianceImage readImageFile(const std::filesystem::path& file, const ImageReading& what) {
    const std::string beginning = readFileBeginning(file, beginningSize);
    const ImageFormat* const format = formatOf(file, beginning);
    if (!what.part.empty() && (format == nullptr || format->parts == nullptr || format->hasPages))
        throw InputError({file.string(), "part " + what.part, "a file without parts",
                          "an OpenEXR image, or no part"});
    if (what.page && (format == nullptr || !format->hasPages))
        throw InputError({file.string(), "page " + std::to_string(*what.page),
                          "a file without pages", "a TIFF image, or no page"});
    if (format != nullptr)
        return format->read(file, what);
    if (const BinaryFormat* const other = binaryFormatOf(beginning))
        throw InputError({file.string(), "byte 0", std::string(other->words),
                          namesOfReadFormats() +
                              (other->isPicture ? ", which hold values and not colours" : "")});
    // What is left is text, or refused as such with line and column.
    return readCsvImage(file);
}

std::vector<ImagePart> imageParts(const std::filesystem::path& file) {
    const ImageFormat* const format = formatOf(file, readFileBeginning(file, beginningSize));
    if (format == nullptr || format->parts == nullptr)
        return {};
    std::vector<ImagePart> parts = format->parts(file);
    return parts.size() > 1 ? parts : std::vector<ImagePart>();
}

bool holdsImage(const std::filesystem::path& file) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(file, unknown) &&
           formatOf(file, readFileBeginning(file, beginningSize)) != nullptr;
}

std::string channelList(const RadianceImage& image) {
    std::string list;
    for (const ImageChannel& channel : image.channels)
        list += (list.empty() ? "" : ", ") + channel.name;
    return list;
}

const ImageChannel& chosenPlane(const RadianceImage& image, const std::string& channel,
                                const std::string& imageName) {
    if (image.empty() || image.channels.empty())
        throw LogicError("an empty image has no channel to choose");
    if (!channel.empty()) {
        if (const ImageChannel* found = image.find(channel))
            return *found;
        throw InputError({imageName, "", "no channel '" + channel + "'",
                          "one of its channels: " + channelList(image)});
    }
    // What is shown in place of radiance stands in front of it.
    const std::string shown = quantityOf(image, image.primary()).name;
    if (image.channels.size() == 1 || (!shown.empty() && shown != "radiance"))
        return image.primary();
    for (const char* usual : {"L", "Y"})
        if (const ImageChannel* found = image.find(usual))
            return *found;
    throw InputError({imageName, "", "several channels and none called L or Y",
                      "the name of one of them: " + channelList(image)});
}

ComparedPlanes comparedPlanes(const RadianceImage& a, const RadianceImage& b,
                              const ComparisonOptions& options) {
    std::string nameA = options.channelA.empty() ? options.channel : options.channelA;
    std::string nameB = options.channelB.empty() ? options.channel : options.channelB;
    const bool areOne = options.channelA.empty() && options.channelB.empty() && !nameA.empty();
    if (areOne && (a.find(nameA) == nullptr) != (b.find(nameA) == nullptr)) {
        const bool lacksA = a.find(nameA) == nullptr;
        std::string& lacking = lacksA ? nameA : nameB;
        const RadianceImage& image = lacksA ? a : b;
        const std::string& file = lacksA ? options.nameA : options.nameB;
        try {
            const std::string usual = chosenPlane(image, "", file).name;
            remarkOn(file,
                     "has no channel '" + lacking + "'; its '" + usual + "' is compared with it");
            lacking = usual;
        } catch (const InputError&) {
            // It is refused below, with the name that was asked for.
        }
    }
    return {chosenPlane(a, nameA, options.nameA), chosenPlane(b, nameB, options.nameB)};
}

} // namespace irsg
