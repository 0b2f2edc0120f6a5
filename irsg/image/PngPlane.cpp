#include "irsg/image/PngPlane.h"

#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <string>

#include <png.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/PixelBound.h"

namespace irsg {

namespace {

/// What lives longer than the long jumps with which libpng reports errors.
struct Decoding {
    std::string bytes;
    std::size_t position = 0;
    std::string complaint;
    std::vector<unsigned char> pixels;
    std::vector<png_bytep> rows;
    png_uint_32 width = 0, height = 0;
    std::size_t bytesPerPixel = 0, bytesPerSample = 1;
    png_structp png = nullptr;
    png_infop info = nullptr;

    ~Decoding() { png_destroy_read_struct(&png, &info, nullptr); }
};

void readBytes(png_structp png, png_bytep into, std::size_t count) {
    auto& decoding = *static_cast<Decoding*>(png_get_io_ptr(png));
    if (count > decoding.bytes.size() - decoding.position)
        png_error(png, "the file ends early");
    std::memcpy(into, decoding.bytes.data() + decoding.position, count);
    decoding.position += count;
}

void keepComplaint(png_structp png, png_const_charp message) {
    static_cast<Decoding*>(png_get_error_ptr(png))->complaint = message;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// False where libpng complained. With `sizeOnly` width and height alone are read.
bool decode(Decoding& d, bool sizeOnly) {
    if (setjmp(png_jmpbuf(d.png)))
        return false;
    png_set_read_fn(d.png, &d, readBytes);
    png_set_user_limits(d.png, largestImageSide_px, largestImageSide_px);
    png_read_info(d.png, d.info);
    d.width = png_get_image_width(d.png, d.info);
    d.height = png_get_image_height(d.png, d.info);
    if (sizeOnly)
        return true;

    // Whole bytes, as they are: no gamma.
    if (png_get_color_type(d.png, d.info) == PNG_COLOR_TYPE_PALETTE)
        png_set_palette_to_rgb(d.png);
    else if (png_get_bit_depth(d.png, d.info) < 8)
        png_set_expand_gray_1_2_4_to_8(d.png);
    png_set_interlace_handling(d.png);
    png_read_update_info(d.png, d.info);

    const std::size_t rowBytes = png_get_rowbytes(d.png, d.info);
    d.bytesPerPixel = rowBytes / d.width;
    d.bytesPerSample = png_get_bit_depth(d.png, d.info) == 16 ? 2 : 1;
    d.pixels.resize(rowBytes * d.height);
    d.rows.resize(d.height);
    for (std::size_t y = 0; y < d.height; ++y)
        d.rows[y] = d.pixels.data() + y * rowBytes;
    png_read_image(d.png, d.rows.data());
    return true;
}

void start(Decoding& d, const std::filesystem::path& file) {
    png_destroy_read_struct(&d.png, &d.info, nullptr);
    d.position = 0;
    d.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &d, keepComplaint, ignoreWarning);
    d.info = d.png ? png_create_info_struct(d.png) : nullptr;
    if (!d.info)
        throw InputError({file.string(), "", "no memory to read it", "a PNG file"});
}

} // namespace

PngPlane readPngPlane(const std::filesystem::path& file) {
    Decoding d;
    d.bytes = readFile(file);
    start(d, file);
    if (decode(d, true))
        checkPixelCount(std::uint64_t{d.width} * d.height, d.bytes.size(), file.string());
    start(d, file);
    if (!decode(d, false))
        throw InputError({file.string(), "byte " + std::to_string(d.position),
                          "a file that cannot be read as PNG (" + d.complaint + ")",
                          "a whole PNG file"});

    PngPlane plane;
    plane.width_px = static_cast<int>(d.width);
    plane.height_px = static_cast<int>(d.height);
    plane.values.reserve(std::size_t{d.width} * d.height);
    for (std::size_t i = 0; i < std::size_t{d.width} * d.height; ++i) {
        const unsigned char* pixel = d.pixels.data() + i * d.bytesPerPixel;
        plane.values.push_back(d.bytesPerSample == 2
                                   ? static_cast<float>(pixel[0] * 256 + pixel[1]) / 65535.0f
                                   : static_cast<float>(pixel[0]) / 255.0f);
    }
    return plane;
}

} // namespace irsg
