#pragma once

#include <filesystem>
#include <vector>

namespace irsg {

/// The red (or only) channel of a picture as linear numbers: integers divided by their largest, 0
/// to 1; floats as they are. No gamma is applied, whatever the file says.
struct TextureImage {
    int width_px = 0, height_px = 0;
    std::vector<float> values; ///< top row first
};

/// What lies beyond the sides of a texture: it again, its mirror image, or its last texel. Colours
/// of borders have no radiance.
enum class TextureWrap { repeat, mirror, edge };

/// Reads PNG of up to 16 bits, OpenEXR, and through OpenSceneGraph the other pictures of
/// OpenableFiles.h: JPEG, TIFF of 8, 16 or 32 bits, Radiance HDR and others. Throws InputError for
/// a file that is missing, unreadable, of a kind that is not opened, or holds a value that is not
/// finite.
TextureImage readTexture(const std::filesystem::path& file);

} // namespace irsg
