#pragma once

#include <optional>

#include <QImage>
#include <QWidget>

#include "irsg/image/ColorMap.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// One plane of an image in false colours, top row at the top. The wheel zooms at the cursor, the
/// right button (or the left with Shift) pans, a drag of the left button selects a rectangle, a
/// double click fits the image into the window. Pixels stay squares when enlarged.
class ImageCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit ImageCanvas(QWidget* parent = nullptr);

    void setPlane(int width, int height, const std::vector<float>& values);
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    void fit();
    void setZoom(double windowPixelsPerPixel);
    double zoom() const { return zoom_; }
    /// Colours as they are shown, one pixel each.
    const QImage& picture() const { return picture_; }

    /// The image pixel under a point of the widget; none outside.
    std::optional<QPoint> pixelAt(const QPointF& point) const;
    QPointF widgetPoint(const QPointF& imagePoint) const;
    std::optional<irsg::PixelRectangle> selection() const { return selection_; }

  signals:
    void hovered(std::optional<QPoint> pixel);
    void selectionChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    void recolor();
    void select(const QPointF& from, const QPointF& to);

    int width_ = 0, height_ = 0;
    std::vector<float> values_;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    QImage picture_;
    double zoom_ = 1.0;
    QPointF corner_; ///< of the image's top left in the widget
    bool fitted_ = true;
    std::optional<QPointF> panFrom_, selectFrom_;
    std::optional<irsg::PixelRectangle> selection_;
};

} // namespace smat::gui
