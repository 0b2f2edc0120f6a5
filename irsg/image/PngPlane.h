#pragma once

#include <filesystem>
#include <vector>

namespace irsg {

/// The first channel (red or grey) of a PNG file as linear values: the numbers in the file divided
/// by the largest one, 255 or 65535, whatever gamma or profile the file names. Palettes are looked
/// up; grey of 1, 2 or 4 bits counts to its own largest number.
struct PngPlane {
    int width_px = 0, height_px = 0;
    std::vector<float> values; ///< 0 to 1, top row first
};

/// Throws InputError for a file that is missing, is not PNG, is damaged, or is larger than 32768 on
/// a side.
PngPlane readPngPlane(const std::filesystem::path& file);

} // namespace irsg
