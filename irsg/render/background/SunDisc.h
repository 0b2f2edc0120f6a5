#pragma once

#include <vector>

#include "irsg/atmosphere/path/SunDiscGeometry.h"
#include "irsg/render/background/FieldRays.h"
#include "irsg/render/background/Horizon.h"

namespace irsg {

/// The disc of the sun in a frame (F32). Its rim is a circle in the sky, which is an ellipse on a
/// flat detector; each pixel gets the exact area of the ellipse in its square. The radiance is
/// E / (sum of coverage times the pixels' solid angles over the whole disc, inside and outside the
/// frame), so that the sum of radiance times solid angle is E for every size and phase.
class SunDisc {
  public:
    static constexpr double diameter_rad = 2.0 * sunDiscRadius_rad; ///< 6.72e-5 sr

    /// `towards`: unit vector to the sun. What lies below the horizon is not seen. Nothing of a sun
    /// that is 90 degrees off axis or more is in the picture.
    SunDisc(const FieldRays& rays, const Horizon& horizon, const Vec3& towards);

    /// A pixel of the frame and how much of its area the disc covers, more than 0 to 1.
    struct Pixel {
        int x = 0, y = 0;
        double coverage = 0.0;
    };
    const std::vector<Pixel>& pixels() const { return pixels_; }
    /// For E in the band on a plane normal to the beam at the sensor, of the whole disc.
    double radiance_W_m2_sr(double irradiance_W_m2) const {
        return pixels_.empty() ? 0.0 : irradiance_W_m2 / drawn_sr_;
    }

  private:
    std::vector<Pixel> pixels_;
    double drawn_sr_ = 0.0; ///< of the whole disc, as the raster has it
};

} // namespace irsg
