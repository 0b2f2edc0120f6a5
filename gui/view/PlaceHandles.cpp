#include "gui/view/PlaceHandles.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QPainter>

#include "gui/view/SeamedDrawing.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

constexpr double reach_px = 9.0; ///< of the mouse
constexpr int ringCorners = 72;

/// Distance of a point from a stretch.
double distanceTo(const QLineF& line, const QPointF& point) {
    const QPointF way = line.p2() - line.p1(), to = point - line.p1();
    const double square = QPointF::dotProduct(way, way);
    const double part =
        square > 0.0 ? std::clamp(QPointF::dotProduct(way, to) / square, 0.0, 1.0) : 0.0;
    return QLineF(line.p1() + part * way, point).length();
}

/// How much of a handle is hidden by looking along it: arrows at the eye, rings edge-on.
constexpr double leastSine = 0.06, leastCosine = 0.25;

} // namespace

const char* keyOf(PlaceHandle handle) {
    switch (handle) {
    case PlaceHandle::east:
        return "east";
    case PlaceHandle::north:
        return "north";
    case PlaceHandle::altitude:
        return "altitude";
    case PlaceHandle::heading:
        return "heading";
    case PlaceHandle::pitch:
        return "pitch";
    case PlaceHandle::roll:
        break;
    }
    return "roll";
}

bool PlaceHandles::has(PlaceHandle handle) const {
    return shifts || (handle != PlaceHandle::east && handle != PlaceHandle::north);
}

irsg::Vec3 PlaceHandles::axis(PlaceHandle handle) const {
    irsg::Attitude turned = pose.attitude;
    switch (handle) {
    case PlaceHandle::east:
        return {1, 0, 0};
    case PlaceHandle::north:
        return {0, 1, 0};
    case PlaceHandle::altitude:
    case PlaceHandle::heading:
        return {0, 0, 1};
    case PlaceHandle::pitch:
        turned.pitch_rad = turned.roll_rad = 0.0;
        return turned.rotation() * irsg::Vec3{1, 0, 0};
    case PlaceHandle::roll:
        break;
    }
    return turned.rotation() * irsg::Vec3{0, 1, 0};
}

irsg::Vec3 PlaceHandles::ringPoint(PlaceHandle handle, double angle_rad) const {
    const irsg::Vec3 normal = axis(handle);
    // Any direction across it to begin with.
    const irsg::Vec3 aside = std::abs(normal.z) < 0.9 ? irsg::Vec3{0, 0, 1} : irsg::Vec3{0, 1, 0};
    const irsg::Vec3 u = irsg::normalized(irsg::cross(aside, normal)), v = irsg::cross(normal, u);
    return pose.position_m + (u * std::cos(angle_rad) + v * std::sin(angle_rad)) * radius_m();
}

QPolygonF PlaceHandles::line(PlaceHandle handle, const ViewProjection& through) const {
    QPolygonF corners;
    if (!has(handle))
        return corners;
    if (!isRing(handle)) {
        if (const auto way =
                through.line(pose.position_m, pose.position_m + axis(handle) * length_m))
            corners << way->p1() << way->p2();
        return corners;
    }
    for (int i = 0; i <= ringCorners; ++i) {
        const irsg::Vec3 point = ringPoint(handle, 2.0 * irsg::pi * i / ringCorners);
        if (through.depth_m(point) <= 1e-6 * radius_m())
            return {};
        corners << through.toWindow(point);
    }
    return corners;
}

std::optional<PlaceHandle> PlaceHandles::at(const QPointF& point,
                                            const ViewProjection& through) const {
    std::optional<PlaceHandle> nearest;
    double least_px = reach_px;
    for (const PlaceHandle handle : allPlaceHandles) {
        const QPolygonF corners = line(handle, through);
        for (qsizetype i = 1; i < corners.size(); ++i) {
            // Arrows meet where all begin: their outer half is what is taken.
            const QPointF begin =
                isRing(handle) ? corners[i - 1] : 0.5 * (corners[i - 1] + corners[i]);
            const double distance_px = distanceTo({begin, corners[i]}, point);
            if (distance_px < least_px && dragged(handle, point, point, through)) {
                least_px = distance_px;
                nearest = handle;
            }
        }
    }
    return nearest;
}

std::optional<double> PlaceHandles::alongAxis(PlaceHandle handle, const QPointF& point,
                                              const ViewProjection& through) const {
    const irsg::Vec3 along = axis(handle), ray = through.ray(point);
    const irsg::Vec3 from = pose.position_m - through.eye.position_m;
    const double cosine = irsg::dot(along, ray), square = 1.0 - cosine * cosine;
    if (square < leastSine * leastSine)
        return std::nullopt;
    return (cosine * irsg::dot(ray, from) - irsg::dot(along, from)) / square;
}

std::optional<irsg::Vec3> PlaceHandles::onPlane(PlaceHandle handle, const QPointF& point,
                                                const ViewProjection& through) const {
    const irsg::Vec3 normal = axis(handle), ray = through.ray(point);
    const double cosine = irsg::dot(normal, ray);
    const double distance_m = irsg::dot(normal, pose.position_m - through.eye.position_m) / cosine;
    if (std::abs(cosine) < leastCosine || !(distance_m > 0.0))
        return std::nullopt;
    return through.eye.position_m + ray * distance_m - pose.position_m;
}

std::optional<double> PlaceHandles::dragged(PlaceHandle handle, const QPointF& from,
                                            const QPointF& to,
                                            const ViewProjection& through) const {
    if (!isRing(handle)) {
        const auto begin = alongAxis(handle, from, through), end = alongAxis(handle, to, through);
        return begin && end ? std::optional(*end - *begin) : std::nullopt;
    }
    const irsg::Vec3 normal = axis(handle);
    const double sign = handle == PlaceHandle::heading ? -1.0 : 1.0;
    const auto begin = onPlane(handle, from, through), end = onPlane(handle, to, through);
    if (begin && end)
        return sign * irsg::degrees(std::atan2(irsg::dot(normal, irsg::cross(*begin, *end)),
                                               irsg::dot(*begin, *end)));
    // Seen edge-on: along the ring where it was taken.
    irsg::Vec3 taken = ringPoint(handle, 0.0);
    double nearest_px = 1e300;
    for (int i = 0; i < ringCorners; ++i) {
        const irsg::Vec3 point = ringPoint(handle, 2.0 * irsg::pi * i / ringCorners);
        if (through.depth_m(point) <= 0.0 ||
            irsg::dot(point - pose.position_m, through.eye.forward()) > 0.0)
            continue; // the far side
        const double distance_px = QLineF(through.toWindow(point), from).length();
        if (distance_px < nearest_px) {
            nearest_px = distance_px;
            taken = point;
        }
    }
    const irsg::Vec3 tangent = irsg::cross(normal, taken - pose.position_m); // m a radian
    constexpr double small_rad = 1e-4;
    const QPointF way =
        (through.toWindow(taken + tangent * small_rad) - through.toWindow(taken)) / small_rad;
    const double square = QPointF::dotProduct(way, way);
    if (!(square > 1.0))
        return std::nullopt;
    return sign * irsg::degrees(QPointF::dotProduct(to - from, way) / square);
}

void PlaceHandles::paint(QPainter& painter, const ViewProjection& through, bool dark) const {
    for (const PlaceHandle handle : allPlaceHandles) {
        const QPolygonF corners = line(handle, through);
        if (corners.isEmpty())
            continue;
        const bool isLit = lit == handle;
        const int color = handle == PlaceHandle::east || handle == PlaceHandle::pitch   ? 0
                          : handle == PlaceHandle::north || handle == PlaceHandle::roll ? 1
                                                                                        : 2;
        const double width_px = isLit ? 4.0 : isRing(handle) ? 1.8 : 2.6;
        if (isRing(handle)) {
            drawSeamedPath(painter, corners, colors::axis(color), width_px, dark);
        } else {
            const QLineF arrow(corners[0], corners[1]);
            drawSeamed(painter, arrow, colors::axis(color), width_px, dark);
            drawArrowHead(painter, arrow, colors::axis(color), isLit ? 7.5 : 6.0, dark);
        }
    }
    if (through.depth_m(pose.position_m) <= 0.0)
        return;
    const QPointF middle = through.toWindow(pose.position_m);
    const double below_px = through.focalLength_px * length_m / through.depth_m(pose.position_m);
    const QString words = value.isEmpty() ? name : name + "   " + value;
    drawSeamedText(painter, middle + QPointF(0.0, below_px + 14.0), words, colors::overlayInk(dark),
                   dark);
}

} // namespace smat::gui
