#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "irsg/image/ColorMap.h"

namespace irsg {

/// An 8-bit sRGB picture to draw on; (0, 0) is the top left pixel.
class Canvas {
  public:
    /// LogicError unless 1 to 65535 pixels a side.
    Canvas(int width, int height, Rgb background = {255, 255, 255});

    int width() const { return width_; }
    int height() const { return height_; }
    Rgb at(int x, int y) const;
    void set(int x, int y, Rgb color);
    /// Lays `color` over a pixel with `coverage` 0 to 1; outside the canvas nothing happens.
    void blend(int x, int y, Rgb color, double coverage);
    /// The part of a rectangle that is on the canvas.
    void fill(int x, int y, int width, int height, Rgb color);
    /// A frame of `thickness` pixels around, and outside of, a rectangle.
    void frame(int x, int y, int width, int height, int thickness, Rgb color);

    /// Three bytes a pixel, row by row from the top.
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  private:
    std::size_t offset(int x, int y) const;

    int width_, height_;
    std::vector<std::uint8_t> bytes_;
};

/// Writes a PNG of 8-bit RGB. Throws InputError where the file cannot be written.
void writePng(const Canvas& canvas, const std::filesystem::path& file);

} // namespace irsg
