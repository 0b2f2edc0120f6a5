#pragma once

#include <optional>

#include <QPolygonF>
#include <QString>

#include "gui/view/ViewProjection.h"
#include "irsg/geometry/view/Pose.h"

class QPainter;

namespace smat::gui {

/// What of a place a handle changes: a coordinate in m or an angle in degrees.
enum class PlaceHandle { east, north, altitude, heading, pitch, roll };
inline constexpr PlaceHandle allPlaceHandles[] = {PlaceHandle::east,     PlaceHandle::north,
                                                  PlaceHandle::altitude, PlaceHandle::heading,
                                                  PlaceHandle::pitch,    PlaceHandle::roll};

/// Key of the ModelField that a handle changes.
const char* keyOf(PlaceHandle handle);

/// The handles by which a model is placed in the view: an arrow along each axis of the world and a
/// ring about each axis that an angle turns about. A value: where they are drawn, what of them is
/// under a point, and how far a drag from one point to another goes.
struct PlaceHandles {
    irsg::Pose pose;       ///< of the model
    double length_m = 1.0; ///< of the arrows
    bool shifts = true;    ///< false for the target, which is the origin of east and north
    QString name;          ///< of the model
    std::optional<PlaceHandle> lit;
    QString value; ///< of what is lit

    bool has(PlaceHandle handle) const;
    static bool isRing(PlaceHandle handle) { return handle >= PlaceHandle::heading; }
    /// Unit vector of the world: along an arrow, or about which a ring turns by the right-hand
    /// rule where its angle grows (the yaw, where it is the heading).
    irsg::Vec3 axis(PlaceHandle handle) const;
    /// As it is drawn; empty where it is behind the eye.
    QPolygonF line(PlaceHandle handle, const ViewProjection& through) const;
    /// The one under a point of the window, nearest first; none farther than some pixels.
    std::optional<PlaceHandle> at(const QPointF& point, const ViewProjection& through) const;
    /// How much a drag changes the value: m along an arrow, degrees about a ring (of the heading:
    /// clockwise from above). No value where the view does not tell.
    std::optional<double> dragged(PlaceHandle handle, const QPointF& from, const QPointF& to,
                                  const ViewProjection& through) const;
    void paint(QPainter& painter, const ViewProjection& through, bool dark) const;

    bool operator==(const PlaceHandles&) const = default;

  private:
    double radius_m() const { return 0.8 * length_m; }
    std::optional<double> alongAxis(PlaceHandle handle, const QPointF& point,
                                    const ViewProjection& through) const;
    std::optional<irsg::Vec3> onPlane(PlaceHandle handle, const QPointF& point,
                                      const ViewProjection& through) const;
    irsg::Vec3 ringPoint(PlaceHandle handle, double angle_rad) const;
};

} // namespace smat::gui
