#include "gui/view/ViewCameras.h"

#include <utility>

namespace smat::gui {

std::optional<OrbitCamera> ViewCameras::other() const {
    return isInspecting() ? std::optional(sensor_) : inspection_;
}

OrbitCamera& ViewCameras::useSensor() {
    shown_ = ViewCamera::sensor;
    return sensor_;
}

OrbitCamera& ViewCameras::inspect() {
    // Looking around begins with what is seen, not with where somebody looked before.
    if (!isInspecting())
        inspection_ = sensor_;
    shown_ = ViewCamera::inspection;
    return *inspection_;
}

void ViewCameras::show(ViewCamera camera) {
    if (camera == ViewCamera::inspection && !inspection_)
        inspection_ = sensor_;
    shown_ = camera;
}

void ViewCameras::forgetInspection() {
    inspection_.reset();
    shown_ = ViewCamera::sensor;
}

void ViewCameras::fit(const ViewBall& ball, double fieldOfView_rad) {
    OrbitCamera& camera = inspect();
    camera.offset_m = ball.centre_m;
    camera.range_m = OrbitCamera::rangeToShow(ball.radius_m, fieldOfView_rad);
}

void ViewCameras::lookAt(ViewSide side) {
    OrbitCamera& camera = inspect();
    const auto look = [&](double azimuth_deg, double elevation_deg) {
        camera.azimuth_deg = azimuth_deg;
        camera.elevation_deg = elevation_deg;
    };
    switch (side) {
    case ViewSide::front:
        return look(0.0, 0.0);
    case ViewSide::rear:
        return look(180.0, 0.0);
    case ViewSide::port:
        return look(-90.0, 0.0);
    case ViewSide::starboard:
        return look(90.0, 0.0);
    case ViewSide::top:
        return look(0.0, 90.0);
    case ViewSide::bottom:
        return look(0.0, -90.0);
    }
}

void ViewCameras::pan(double right_px, double down_px, const ViewProjection& through) {
    OrbitCamera& camera = inspect();
    const double metresPerPixel = camera.range_m / through.focalLength_px;
    camera.offset_m = camera.offset_m - through.eye.right * (right_px * metresPerPixel) +
                      through.eye.up * (down_px * metresPerPixel);
}

} // namespace smat::gui
