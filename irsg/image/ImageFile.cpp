#include "irsg/image/ImageFile.h"

#include <array>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Wording.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ImageFormat.h"

namespace irsg {

namespace {

/// How files begin that hold pictures, but no radiance.
struct Signature {
    std::string_view bytes, format;
};
constexpr std::array<Signature, 5> otherFormats = {{{"\x89PNG", "a PNG picture"},
                                                    {"\xFF\xD8\xFF", "a JPEG picture"},
                                                    {"GIF8", "a GIF picture"},
                                                    {"SIMPLE  =", "a FITS file"},
                                                    {"SQLite format 3", "a database"}}};

constexpr std::size_t beginningSize = std::size_t{256} << 10;

const ImageFormat* formatThatBegins(std::string_view beginning) {
    for (const ImageFormat* format : imageFormats())
        if (format->read != nullptr && format->recognises(beginning))
            return format;
    return nullptr;
}

/// "OpenEXR image, TIFF image or values as text".
std::string namesOfReadFormats() {
    std::vector<std::string> names;
    for (const ImageFormat* format : imageFormats())
        if (format->read != nullptr)
            names.emplace_back(format->name);
    return alternatives(names);
}

} // namespace

RadianceImage readImageFile(const std::filesystem::path& file) {
    const std::string beginning = readFileBeginning(file, beginningSize);
    if (const ImageFormat* format = formatThatBegins(beginning))
        return format->read(file);
    for (const Signature& other : otherFormats)
        if (beginning.starts_with(other.bytes))
            throw InputError({file.string(), "byte 0", std::string(other.format),
                              namesOfReadFormats() + ", which hold values and not colours"});
    // What is left is text, or refused as such with line and column.
    return readCsvImage(file);
}

bool holdsImage(const std::filesystem::path& file) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(file, unknown) &&
           formatThatBegins(readFileBeginning(file, beginningSize)) != nullptr;
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
    if (image.channels.size() == 1)
        return image.primary();
    for (const char* usual : {"L", "Y"})
        if (const ImageChannel* found = image.find(usual))
            return *found;
    throw InputError({imageName, "", "several channels and none called L or Y",
                      "the name of one of them: " + channelList(image)});
}

} // namespace irsg
