#include "irsg/geometry/conversion/TextureImage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <osgDB/FileNameUtils>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/OsgTexture.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/SandboxedPictures.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/PngPlane.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

void checkFinite(const TextureImage& image, const std::string& name) {
    const auto wrong =
        std::ranges::find_if(image.values, [](float v) { return !std::isfinite(v); });
    if (wrong == image.values.end())
        return;
    const auto at = static_cast<std::size_t>(wrong - image.values.begin());
    const auto width = static_cast<std::size_t>(image.width_px);
    throw InputError({name,
                      "texel " + std::to_string(at % width) + ", " + std::to_string(at / width) +
                          " from the top left",
                      std::isnan(*wrong) ? "not a number" : "an infinite value", "finite values"});
}

TextureImage readExrTexture(const fs::path& file) {
    const RadianceImage image = readExr(file);
    const ImageChannel* red = image.find("R");
    return {image.width(), image.height(), red ? red->values : image.primary().values};
}

osg::ref_ptr<osg::Image> readSandboxed(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        throw InputError({file.string(), "", "no such file", expectationOf(FileKind::picture)});
    ReaderProcess process;
    return readPictureSandboxed(process, file);
}

template <typename Number>
float linear(const unsigned char* at) {
    Number number;
    std::memcpy(&number, at, sizeof number);
    if constexpr (std::is_integral_v<Number>)
        return static_cast<float>(static_cast<double>(number) /
                                  static_cast<double>(std::numeric_limits<Number>::max()));
    else
        return static_cast<float>(number);
}

using Reading = float (*)(const unsigned char*);

Reading readingOf(GLenum dataType) {
    switch (dataType) {
    case GL_UNSIGNED_BYTE:
        return linear<std::uint8_t>;
    case GL_UNSIGNED_SHORT:
        return linear<std::uint16_t>;
    case GL_UNSIGNED_INT:
        return linear<std::uint32_t>;
    case GL_FLOAT:
        return linear<float>;
    case GL_DOUBLE:
        return linear<double>;
    default:
        return nullptr;
    }
}

} // namespace

TextureImage textureOf(const osg::Image& image, const std::string& name) {
    const Reading reading = readingOf(image.getDataType());
    const GLenum format = image.getPixelFormat();
    if (!reading || image.isCompressed() || image.r() != 1 || image.s() < 1 || image.t() < 1 ||
        format == GL_ALPHA || format == GL_DEPTH_COMPONENT)
        throw InputError({name, "", "a texture without plain red numbers",
                          "an image of 8, 16 or 32 bits a channel that is not compressed"});
    const std::size_t step = image.getPixelSizeInBits() / 8;
    const std::size_t red = format == GL_BGR || format == GL_BGRA
                                ? 2 * step / osg::Image::computeNumComponents(format)
                                : 0;

    TextureImage result{image.s(), image.t(), {}};
    result.values.reserve(static_cast<std::size_t>(image.s()) *
                          static_cast<std::size_t>(image.t()));
    const bool topFirst = image.getOrigin() == osg::Image::TOP_LEFT;
    for (int y = 0; y < image.t(); ++y) {
        const int row = topFirst ? y : image.t() - 1 - y;
        const unsigned char* start = image.data(0, static_cast<unsigned int>(row));
        for (std::size_t x = 0; x < static_cast<std::size_t>(image.s()); ++x)
            result.values.push_back(reading(start + x * step + red));
    }
    checkFinite(result, name);
    return result;
}

TextureImage readTexture(const fs::path& file) {
    if (const auto refusal = refusalOf(file.string(), FileKind::picture))
        throw InputError({file.string(), "", *refusal, expectationOf(FileKind::picture)});
    const std::string extension = osgDB::getLowerCaseFileExtension(file.string());
    if (extension == "png") {
        PngPlane plane = readPngPlane(file);
        return {plane.width_px, plane.height_px, std::move(plane.values)};
    }
    if (extension == "exr") {
        TextureImage image = readExrTexture(file);
        checkFinite(image, file.string());
        return image;
    }
    return textureOf(*readSandboxed(file), file.string());
}

} // namespace irsg
