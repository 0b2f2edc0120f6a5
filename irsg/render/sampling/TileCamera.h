#pragma once

#include "irsg/geometry/view/CameraFrame.h"

namespace irsg {

/// Diameter of a sphere in pixels of a sensor whose optical axis points at it: the true sphere, not
/// that of the box around it. Infinite for a camera inside.
double sphereDiameter_px(const CameraFrame& camera, const Vec3& centre_m, double radius_m);

/// The smallest power of two not below a number of pixels, at least 2.
int nextPowerOfTwo(double pixels);

/// Width that so many pixels of a sensor cover at a distance along its axis, m.
double widthAtDistance_m(const Sensor& sensor, double pixels, double distance_m);

/// The camera of the report's zoom antialiasing (section 6, phase 1): at the place of `camera`,
/// looking at `centre_m`, its upright axis as near to that of `camera` as can be; its square field
/// holds `side_px` pixels of the sensor and is drawn `size` samples wide.
CameraFrame tileCamera(const CameraFrame& camera, const Vec3& centre_m, double side_px, int size);

/// A square that faces the camera of a zoom and carries its texture.
class Billboard {
  public:
    Billboard(const CameraFrame& zoom, const Vec3& centre_m);

    /// Where the line of sight of a pixel of `camera` meets the square's plane: texture
    /// coordinates, 0 to 1 from its top left corner; nothing where it does not.
    std::optional<std::pair<double, double>> at(const CameraFrame& camera, double x,
                                                double y) const;
    /// Pixels of `camera` whose middles may lie on the square, inside the frame.
    PixelRegion pixels(const CameraFrame& camera) const;

  private:
    Vec3 centre_m_, right_, up_, normal_;
    double half_m_;
};

} // namespace irsg
