#pragma once

#include <optional>

#include <QPointF>
#include <QRectF>
#include <QSize>

namespace smat::gui {

/// The part of an image that a canvas shows; canvases of one size share it.
struct CanvasView {
    double zoom = 1.0; ///< window pixels per image pixel
    QPointF centre;    ///< of the widget, in image pixels
    bool fitted = true;
};

/// Where an image lies in a room of the window, and how large: which pixel is under a point.
/// Lengths in the room are in window pixels, y down.
class CanvasPlacement {
  public:
    void setImage(const QSize& pixels) { image_ = pixels; }
    /// The whole image, as large as there is room, from now on. False where there is none.
    bool fit(const QSize& room);
    bool isFitted() const { return fitted_; }
    /// The point keeps its pixel. Zooms are bounded.
    void zoomAt(const QPointF& point, double zoom);
    void moveBy(const QPointF& way);
    /// A pixel in the middle, enlarged at least `zoom` times.
    void centreOn(const QPoint& pixel, double zoom, const QSize& room);

    double zoom() const { return zoom_; }
    CanvasView view(const QSize& room) const;
    void setView(const CanvasView& view, const QSize& room);

    QPointF inImage(const QPointF& point) const { return (point - corner_) / zoom_; }
    QPointF inRoom(const QPointF& imagePoint) const { return corner_ + imagePoint * zoom_; }
    QRectF inRoom(const QRectF& pixels) const {
        return {inRoom(pixels.topLeft()), pixels.size() * zoom_};
    }
    QRectF imageInRoom() const { return inRoom(QRectF(QPointF(), QSizeF(image_))); }
    /// None outside of the image.
    std::optional<QPoint> pixelAt(const QPointF& point) const;

  private:
    QSize image_;
    double zoom_ = 1.0;
    QPointF corner_; ///< of the image's top left in the room
    bool fitted_ = true;
};

} // namespace smat::gui
