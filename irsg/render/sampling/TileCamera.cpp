#include "irsg/render/sampling/TileCamera.h"

#include <cmath>
#include <limits>

namespace irsg {

double sphereDiameter_px(const CameraFrame& camera, const Vec3& centre_m, double radius_m) {
    const double distance_m = length(centre_m - camera.viewpoint().position_m);
    if (distance_m <= radius_m)
        return std::numeric_limits<double>::infinity();
    const double tangent = std::tan(std::asin(radius_m / distance_m));
    return 2.0 * tangent / camera.sensor().pixelPitch();
}

int nextPowerOfTwo(double pixels) {
    int power = 2;
    while (power < pixels)
        power *= 2;
    return power;
}

double widthAtDistance_m(const Sensor& sensor, double pixels, double distance_m) {
    return pixels * sensor.pixelPitch() * distance_m;
}

CameraFrame tileCamera(const CameraFrame& camera, const Vec3& centre_m, double side_px, int size) {
    const Viewpoint& eye = camera.viewpoint();
    Sensor sensor = camera.sensor();
    sensor.horizontalFieldOfView_rad = 2.0 * std::atan(0.5 * side_px * sensor.pixelPitch());
    sensor.width_px = sensor.height_px = size;
    return {sensor, Viewpoint::lookAt(eye.position_m, centre_m, eye.up, eye.backward)};
}

Billboard::Billboard(const CameraFrame& zoom, const Vec3& centre_m)
    : centre_m_(centre_m),
      right_(zoom.viewpoint().right),
      up_(zoom.viewpoint().up),
      normal_(zoom.viewpoint().backward),
      half_m_(0.5 * widthAtDistance_m(zoom.sensor(), zoom.sensor().width_px,
                                      length(centre_m - zoom.viewpoint().position_m))) {}

std::optional<std::pair<double, double>> Billboard::at(const CameraFrame& camera, double x,
                                                       double y) const {
    const Sensor& sensor = camera.sensor();
    const Viewpoint& eye = camera.viewpoint();
    const double right = (x - 0.5 * sensor.width_px) * sensor.pixelPitch();
    const double up = (0.5 * sensor.height_px - y) * sensor.pixelPitch();
    const Vec3 ray = eye.forward() + eye.right * right + eye.up * up;
    const double towards = dot(ray, normal_);
    if (towards >= 0.0)
        return std::nullopt;
    const Vec3 toCentre = centre_m_ - eye.position_m;
    const Vec3 arm = ray * (dot(toCentre, normal_) / towards) - toCentre;
    const double u = 0.5 + 0.5 * dot(arm, right_) / half_m_;
    const double v = 0.5 - 0.5 * dot(arm, up_) / half_m_;
    if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0)
        return std::nullopt;
    return std::pair{u, v};
}

PixelRegion Billboard::pixels(const CameraFrame& camera) const {
    // A sphere around the square bounds it.
    const double reach_m = std::sqrt(2.0) * half_m_;
    const Sensor& sensor = camera.sensor();
    ImageRectangle extent{0.0, 0.0, static_cast<double>(sensor.width_px),
                          static_cast<double>(sensor.height_px)};
    if (const auto sphere = camera.extentOfSphere(centre_m_, reach_m))
        extent = extent.intersectedWith(*sphere);
    if (extent.empty())
        return {};
    const int x = static_cast<int>(std::floor(extent.left));
    const int y = static_cast<int>(std::floor(extent.top));
    return {x, y, static_cast<int>(std::ceil(extent.right)) - x,
            static_cast<int>(std::ceil(extent.bottom)) - y};
}

} // namespace irsg
