#include "gui/view/ViewProjection.h"

#include <algorithm>
#include <cmath>

namespace smat::gui {

QRectF frameRectIn(const ViewFrame& frame, const QSizeF& window) {
    const double sensor = static_cast<double>(frame.width_px) / frame.height_px;
    QSizeF inner(window.width(), window.width() / sensor);
    if (inner.height() > window.height())
        inner = QSizeF(window.height() * sensor, window.height());
    return {
        QPointF((window.width() - inner.width()) / 2.0, (window.height() - inner.height()) / 2.0),
        inner};
}

double fieldOfViewOf(const ViewFrame& frame, const QSizeF& window) {
    const double wider = window.width() * frame.height_px / (window.height() * frame.width_px);
    if (wider <= 1.0)
        return frame.horizontalFieldOfView_rad;
    return 2.0 * std::atan(std::tan(frame.horizontalFieldOfView_rad / 2.0) * wider);
}

bool ViewProjection::operator==(const ViewProjection& other) const {
    return eye.position_m == other.eye.position_m && eye.right == other.eye.right &&
           eye.up == other.eye.up && eye.backward == other.eye.backward && window == other.window &&
           focalLength_px == other.focalLength_px;
}

ViewProjection ViewProjection::of(const irsg::Viewpoint& eye, const QSizeF& window,
                                  double horizontalFieldOfView_rad) {
    return {eye, window, 0.5 * window.width() / std::tan(0.5 * horizontalFieldOfView_rad)};
}

double ViewProjection::depth_m(const irsg::Vec3& world) const {
    return irsg::dot(world - eye.position_m, eye.forward());
}

QPointF ViewProjection::toWindow(const irsg::Vec3& world) const {
    const irsg::Vec3 from = world - eye.position_m;
    const double scale = focalLength_px / irsg::dot(from, eye.forward());
    return {0.5 * window.width() + scale * irsg::dot(from, eye.right),
            0.5 * window.height() - scale * irsg::dot(from, eye.up)};
}

std::optional<QLineF> ViewProjection::line(const irsg::Vec3& from, const irsg::Vec3& to) const {
    // Cut a little before the eye, where the picture of a point is still a number.
    const double start = depth_m(from);
    const double end = depth_m(to);
    const double least = 1e-6 * std::max({std::abs(start), std::abs(end), 1e-6});
    if (start < least && end < least)
        return std::nullopt;
    irsg::Vec3 first = from;
    irsg::Vec3 last = to;
    if (start < least)
        first = from + (to - from) * ((least - start) / (end - start));
    if (end < least)
        last = from + (to - from) * ((least - start) / (end - start));
    return QLineF(toWindow(first), toWindow(last));
}

irsg::Vec3 ViewProjection::ray(const QPointF& point) const {
    return irsg::normalized(eye.forward() +
                            eye.right * ((point.x() - 0.5 * window.width()) / focalLength_px) -
                            eye.up * ((point.y() - 0.5 * window.height()) / focalLength_px));
}

} // namespace smat::gui
