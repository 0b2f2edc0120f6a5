#include "irsg/image/ImageFormat.h"

#include <algorithm>
#include <sstream>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

/// Those that a format reads; none of a picture.
std::vector<std::string> readExtensionsOf(const ImageFormat& format) {
    if (format.read == nullptr)
        return {};
    return wordsOf(std::string(format.extensions) + " " + format.alsoRead);
}

} // namespace

std::vector<std::string> ImageFormat::extensionList() const {
    return wordsOf(extensions);
}

const ImageFormat* imageFormatOf(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    for (const ImageFormat* format : imageFormats())
        if (std::ranges::count(format->extensionList(), extension) > 0)
            return format;
    return nullptr;
}

const ImageFormat& requiredImageFormat(const std::filesystem::path& file) {
    if (const ImageFormat* format = imageFormatOf(file))
        return *format;
    throw InputError(
        {file.string(), "",
         file.has_extension() ? "the ending '" + file.extension().string() + "'" : "no ending",
         imageExtensionNames()});
}

std::vector<const ImageFormat*> readImageFormats() {
    std::vector<const ImageFormat*> all = foreignImageFormats();
    for (const ImageFormat* format : imageFormats())
        if (format->read != nullptr)
            all.push_back(format);
    return all;
}

const ImageFormat* readableImageFormatOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    for (const ImageFormat* format : readImageFormats())
        if (std::ranges::count(readExtensionsOf(*format), extension) > 0)
            return format;
    return nullptr;
}

std::vector<std::string> imageExtensions() {
    std::vector<std::string> all;
    for (const ImageFormat* format : imageFormats())
        for (std::string& extension : format->extensionList())
            all.push_back(std::move(extension));
    return all;
}

std::vector<std::string> readableImageExtensions() {
    std::vector<std::string> all;
    for (const ImageFormat* format : imageFormats())
        for (std::string& extension : readExtensionsOf(*format))
            all.push_back(std::move(extension));
    for (const ImageFormat* format : foreignImageFormats())
        for (std::string& extension : readExtensionsOf(*format))
            all.push_back(std::move(extension));
    return all;
}

std::string imageExtensionNames() {
    return alternatives(imageExtensions());
}

void writeImageFile(const RadianceImage& image, const std::filesystem::path& file,
                    const ImageWriting& how) {
    requiredImageFormat(file).write(image, file, how);
}

} // namespace irsg
