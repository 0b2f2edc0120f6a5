#include "gui/image/CanvasPlacement.h"

#include <algorithm>
#include <cmath>

namespace smat::gui {
namespace {

constexpr double leastZoom = 0.02, largestZoom = 200.0;

QPointF middleOf(const QSize& room) {
    return {room.width() / 2.0, room.height() / 2.0};
}

} // namespace

bool CanvasPlacement::fit(const QSize& room) {
    fitted_ = true;
    if (image_.isEmpty() || room.isEmpty())
        return false;
    zoom_ = std::min(static_cast<double>(room.width()) / image_.width(),
                     static_cast<double>(room.height()) / image_.height());
    corner_ =
        QPointF(room.width() - zoom_ * image_.width(), room.height() - zoom_ * image_.height()) /
        2.0;
    return true;
}

void CanvasPlacement::zoomAt(const QPointF& point, double zoom) {
    const double to = std::clamp(zoom, leastZoom, largestZoom);
    corner_ = point + (corner_ - point) * (to / zoom_);
    zoom_ = to;
    fitted_ = false;
}

void CanvasPlacement::moveBy(const QPointF& way) {
    corner_ += way;
    fitted_ = false;
}

void CanvasPlacement::centreOn(const QPoint& pixel, double zoom, const QSize& room) {
    zoom_ = std::clamp(std::max(zoom, zoom_), leastZoom, largestZoom);
    corner_ = middleOf(room) - (QPointF(pixel) + QPointF(0.5, 0.5)) * zoom_;
    fitted_ = false;
}

CanvasView CanvasPlacement::view(const QSize& room) const {
    return {zoom_, inImage(middleOf(room)), fitted_};
}

void CanvasPlacement::setView(const CanvasView& view, const QSize& room) {
    zoom_ = view.zoom;
    corner_ = middleOf(room) - view.centre * view.zoom;
    fitted_ = view.fitted;
}

std::optional<QPoint> CanvasPlacement::pixelAt(const QPointF& point) const {
    const QPointF p = inImage(point);
    const QPoint pixel(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    if (!QRect(QPoint(), image_).contains(pixel))
        return std::nullopt;
    return pixel;
}

} // namespace smat::gui
