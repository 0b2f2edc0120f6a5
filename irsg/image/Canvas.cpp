#include "irsg/image/Canvas.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <png.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"

namespace irsg {

namespace {

constexpr int largestSide = 65535;

} // namespace

Canvas::Canvas(int width, int height, Rgb background) : width_(width), height_(height) {
    if (width < 1 || height < 1 || width > largestSide || height > largestSide)
        throw LogicError("a canvas of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels was asked for");
    bytes_.resize(offset(0, height));
    fill(0, 0, width, height, background);
}

std::size_t Canvas::offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x));
}

Rgb Canvas::at(int x, int y) const {
    const std::size_t i = offset(x, y);
    return {bytes_.at(i), bytes_.at(i + 1), bytes_.at(i + 2)};
}

void Canvas::set(int x, int y, Rgb color) {
    const std::size_t i = offset(x, y);
    bytes_[i] = color.red;
    bytes_[i + 1] = color.green;
    bytes_[i + 2] = color.blue;
}

void Canvas::blend(int x, int y, Rgb color, double coverage) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_)
        return;
    const Rgb old = at(x, y);
    const auto mix = [coverage](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(from + coverage * (to - from)));
    };
    set(x, y, {mix(old.red, color.red), mix(old.green, color.green), mix(old.blue, color.blue)});
}

void Canvas::fill(int x, int y, int width, int height, Rgb color) {
    for (int row = std::max(y, 0); row < std::min(y + height, height_); ++row)
        for (int column = std::max(x, 0); column < std::min(x + width, width_); ++column)
            set(column, row, color);
}

void Canvas::frame(int x, int y, int width, int height, int thickness, Rgb color) {
    fill(x - thickness, y - thickness, width + 2 * thickness, thickness, color);
    fill(x - thickness, y + height, width + 2 * thickness, thickness, color);
    fill(x - thickness, y, thickness, height, color);
    fill(x + width, y, thickness, height, color);
}

void writePng(const Canvas& canvas, const std::filesystem::path& file) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.format = PNG_FORMAT_RGB;
    picture.width = static_cast<png_uint_32>(canvas.width());
    picture.height = static_cast<png_uint_32>(canvas.height());

    // The first call says how many bytes the second one needs.
    png_alloc_size_t size = 0;
    std::string bytes;
    const void* pixels = canvas.bytes().data();
    if (png_image_write_to_memory(&picture, nullptr, &size, 0, pixels, 0, nullptr) != 0) {
        bytes.resize(size);
        png_image_write_to_memory(&picture, bytes.data(), &size, 0, pixels, 0, nullptr);
    }
    const std::string problem = PNG_IMAGE_FAILED(picture) ? picture.message : "";
    png_image_free(&picture);
    if (!problem.empty())
        throw LogicError("a picture could not be made into PNG: " + problem);
    bytes.resize(size);
    writeFileDurably(file, bytes);
}

} // namespace irsg
