#pragma once

#include <optional>

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "irsg/geometry/view/Pose.h"

namespace smat::gui {

/// What the sensor sees, for the frame of the view.
struct ViewFrame {
    double horizontalFieldOfView_rad = 0.035;
    int width_px = 640, height_px = 512;
    bool operator==(const ViewFrame&) const = default;
};

/// The widest the sensor's frame gets in a window of this size with all of it in sight.
QRectF frameRectIn(const ViewFrame& frame, const QSizeF& window);
/// Horizontal field of view of a window in which the sensor's frame is fitted, rad: that of the
/// sensor where both have the same shape.
double fieldOfViewOf(const ViewFrame& frame, const QSizeF& window);

/// How the view maps the world to its window: a pinhole at the eye with square pixels. Points are
/// in the window's own units, from its top left corner, pixel centres at half numbers.
struct ViewProjection {
    irsg::Viewpoint eye;
    QSizeF window{1.0, 1.0};
    double focalLength_px = 1.0; ///< window units at unit depth

    static ViewProjection of(const irsg::Viewpoint& eye, const QSizeF& window,
                             double horizontalFieldOfView_rad);
    /// Distance along the view direction, m; behind the eye below 0.
    double depth_m(const irsg::Vec3& world) const;
    /// Of a point before the eye.
    QPointF toWindow(const irsg::Vec3& world) const;
    /// The part of a straight line before the eye; none where all of it is behind.
    std::optional<QLineF> line(const irsg::Vec3& from, const irsg::Vec3& to) const;
    /// Unit vector into the world through a point of the window.
    irsg::Vec3 ray(const QPointF& point) const;

    bool operator==(const ViewProjection& other) const;
};

} // namespace smat::gui
