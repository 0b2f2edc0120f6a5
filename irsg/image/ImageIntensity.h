#pragma once

#include <optional>

#include "irsg/image/ImageStatistics.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// What an image of ours says of its camera: a pinhole with square pixels on a flat detector, and
/// the distance of the target.
struct ImageGeometry {
    double horizontalFieldOfView_deg = 0.0; ///< attribute sensor.horizontal_field_of_view_deg
    double range_m = 0.0;                   ///< attribute range_m
    double background_W_m2_sr = 0.0;        ///< attribute background_W_m2_sr, a mean

    bool operator==(const ImageGeometry&) const = default;
};

/// None unless all three attributes are there and usable (0 < field < 180, range > 0, finite).
std::optional<ImageGeometry> geometryOf(const RadianceImage& image);

/// Solid angle of every pixel of a width x height image, sr: p^2 cos^3 theta / f^2, theta at the
/// pixel's centre, p/f = 2 tan(field/2) / width. Computed a row at a time.
class PixelSolidAngles {
  public:
    PixelSolidAngles(int width, int height, double horizontalFieldOfView_deg);
    double at_sr(int x, int y) const;

  private:
    double pitch_, centreX_, centreY_;
};

/// Contrast intensity of a plane of radiance, W sr-1: sum of (L - L_bg) omega R^2 over the finite
/// pixels of the image or of a rectangle. None where the plane is not radiance in W m-2 sr-1 or the
/// image does not know its geometry. Throws InputError for a rectangle that is not in the image.
std::optional<double>
contrastIntensity_W_sr(const RadianceImage& image, const ImageChannel& plane,
                       const std::optional<PixelRectangle>& rectangle = std::nullopt);

/// A plane of radiance in W m-2 sr-1, by its unit.
bool isRadiance(const ImageChannel& plane);

} // namespace irsg
