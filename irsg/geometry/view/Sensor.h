#pragma once

#include "irsg/radiometry/Band.h"

namespace irsg {

inline constexpr int largestResolution_px = 16384;

/// A pinhole camera with square pixels on a flat detector. Pixel (0, 0) is the top left one.
struct Sensor {
    int width_px = 640;
    int height_px = 512;
    double horizontalFieldOfView_rad = 0.0349; ///< 0 to pi, exclusive
    Band band = Band::topHat(3.0, 5.0);

    /// Throws InputError for a resolution below 1 x 1 or above largestResolution_px, or a field of
    /// view out of range.
    void check() const;
    /// p / f: the side of a pixel at unit focal length.
    double pixelPitch() const;
    /// Solid angle of a pixel, p^2 cos^3 theta / f^2, theta at the pixel's centre.
    double pixelSolidAngle_sr(int x, int y) const;
    double cosOffAxis(int x, int y) const;
    bool operator==(const Sensor&) const = default;
};

} // namespace irsg
