#pragma once

namespace irsg {

/// How texels become radiance: slope * (texel - offset), W m-2 sr-1 (report, textureRadianceSlope
/// and textureColorOffset).
struct TextureScale {
    double slope_W_m2_sr = 1.0;
    double offset = 0.0;

    /// A texel equal to the offset, as a float, adds nothing at all.
    double radiance_W_m2_sr(double texel) const {
        return slope_W_m2_sr * (texel - static_cast<double>(static_cast<float>(offset)));
    }
    bool operator==(const TextureScale&) const = default;
};

} // namespace irsg
