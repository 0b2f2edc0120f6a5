#include "irsg/image/ImageFile.h"

#include <array>
#include <string_view>

#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReading.h"

namespace irsg {

namespace {

/// How files begin that hold pictures, but no radiance.
struct Signature {
    std::string_view bytes, format;
};
constexpr std::array<Signature, 7> otherFormats = {{{"\x89PNG", "a PNG picture"},
                                                    {"\xFF\xD8\xFF", "a JPEG picture"},
                                                    {"II*", "a TIFF file"},
                                                    {"MM", "a TIFF file"},
                                                    {"GIF8", "a GIF picture"},
                                                    {"SIMPLE  =", "a FITS file"},
                                                    {"SQLite format 3", "a database"}}};

constexpr std::string_view exrBytes = "\x76\x2f\x31\x01";

} // namespace

RadianceImage readImageFile(const std::filesystem::path& file) {
    const std::string beginning = readFileBeginning(file, 16);
    if (beginning.starts_with(exrBytes))
        return readExr(file);
    for (const Signature& other : otherFormats)
        if (beginning.starts_with(other.bytes))
            throw InputError({file.string(), "byte 0", std::string(other.format),
                              "OpenEXR or CSV, which hold values and not colours"});
    return readCsvImage(file);
}

bool holdsImage(const std::filesystem::path& file) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(file, unknown))
        return false;
    const std::string beginning = readFileBeginning(file, std::size_t{256} << 10);
    if (beginning.starts_with(exrBytes))
        return true;
    return beginning.find('\0') == std::string::npos && beginsAsCsvImage(beginning);
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
