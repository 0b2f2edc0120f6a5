#include "gui/workbench/OrbitCamera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace smat::gui {
namespace {
constexpr double radiansPerDegree = std::numbers::pi / 180.0;
}

void OrbitCamera::turn(double right, double down) {
    azimuth_deg = std::remainder(azimuth_deg + right, 360.0);
    elevation_deg = std::clamp(elevation_deg + down, -90.0, 90.0);
}

void OrbitCamera::approach(double factor) {
    range_m = std::clamp(range_m * factor, 1e-3, 1e8);
}

double OrbitCamera::rangeToShow(double radius_m, double fieldOfView_rad) {
    const double part = 0.85;
    return std::max(radius_m, 1e-3) / std::sin(0.5 * part * std::min(fieldOfView_rad, 3.0));
}

irsg::Viewpoint OrbitCamera::viewpoint(const irsg::Vec3& referencePoint, double yaw_rad) const {
    return irsg::Viewpoint::about(referencePoint + offset_m, yaw_rad,
                                  azimuth_deg * radiansPerDegree, elevation_deg * radiansPerDegree,
                                  range_m);
}

} // namespace smat::gui
