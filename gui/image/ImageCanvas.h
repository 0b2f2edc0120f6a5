#pragma once

#include <optional>

#include <QLine>
#include <QWidget>

#include "gui/image/CanvasPlacement.h"
#include "gui/image/ColoredPlane.h"
#include "gui/image/IsoLine.h"
#include "gui/image/PixelSelection.h"
#include "gui/widgets/LatestTask.h"

namespace smat::gui {

/// One plane of an image in false colours, top row at the top. The wheel zooms at the cursor, the
/// right button (or the left with Shift) pans, a drag of the left button selects a rectangle, a
/// double click fits the image into the window. Pixels stay squares when enlarged, and when there
/// is room their values are printed on them. A large plane is coloured in another thread: until
/// then the canvas shows what it showed, and that it is colouring where that was of another size
/// or another image.
///
/// Keys: the arrows move the pixel cursor (with Shift they draw a rectangle, with Ctrl they pan),
/// + and - zoom, F fits, A shows one image pixel per screen pixel, Escape drops the rectangle.
class ImageCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit ImageCanvas(QWidget* parent = nullptr);

    /// Where there is `light` the picture has its colours; `values` are what is read and printed.
    void setPlane(int width, int height, SharedValues values,
                  const std::optional<LightPlanes>& light = {});
    void setPlane(int width, int height, const std::vector<float>& values);
    /// Nothing to show but the hint.
    void clear();
    /// Before the planes of another image: what is shown goes at once, whatever its size, and the
    /// canvas says that it is colouring until it has the new picture.
    void forgetPicture();
    /// What is to be done for an image to appear.
    void setHint(const QString& hint) { hint_ = hint; }
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    /// Nothing is coloured anew before the next setColors: its limits are still to be found.
    void awaitColors() { awaitsColors_ = true; }
    /// Whether colours are awaited or in the making.
    bool isBusy() const;
    void setMarks(std::vector<std::uint8_t> marks);
    /// Rectangles drawn over the image, in image pixels.
    void setOutlines(std::vector<QRectF> outlines);
    const std::vector<QRectF>& outlines() const { return outlines_; }
    void setIsoLines(std::vector<IsoLine> lines);
    const std::vector<IsoLine>& isoLines() const { return isoLines_; }
    /// Pixels that are marked with their numbers, from 1.
    void setSpots(std::vector<QPoint> spots);
    const std::vector<QPoint>& spots() const { return spots_; }
    /// From now on a drag of the left button draws a line from pixel to pixel instead of a
    /// rectangle, and a click is a line of one pixel; arrows move that, with Shift its end.
    void setLineMode(bool on);
    std::optional<QLine> line() const { return line_; }
    /// Another plane of the same size, to be shown in place of the first, or beside it.
    void setSecond(SharedValues values);
    void setSecondShown(bool shown);
    bool isSecondShown() const { return secondShown_; }
    /// The second plane is shown from this fraction of the widget's width on; none: not at all.
    void setWipe(std::optional<double> fraction);

    bool hasImage() const { return !plane_.isEmpty(); }
    void fit();
    void setZoom(double windowPixelsPerPixel);
    void showActualSize();
    double zoom() const { return placement_.zoom(); }
    CanvasView view() const { return placement_.view(size()); }
    void setView(const CanvasView& view);
    /// Moves the image so that a pixel lies in the middle, enlarged at least `zoom` times.
    void centreOn(const QPoint& pixel, double zoom);
    /// Colours as they are shown, one pixel each.
    const QImage& picture() const { return plane_.picture(); }

    /// The image pixel under a point of the widget; none outside.
    std::optional<QPoint> pixelAt(const QPointF& point) const { return placement_.pixelAt(point); }
    QPointF widgetPoint(const QPointF& imagePoint) const { return placement_.inRoom(imagePoint); }
    std::optional<irsg::PixelRectangle> selection() const { return chosen_.rectangle(); }
    /// Without a signal. What lies outside of the image is cut off.
    void setSelection(const std::optional<irsg::PixelRectangle>& selection);
    /// The pixel that is read, outlined; without a signal.
    void setCursorPixel(std::optional<QPoint> pixel);
    std::optional<QPoint> cursorPixel() const { return chosen_.cursor(); }
    /// Zoom from which on values are printed on the pixels.
    double printingZoom() const;

  signals:
    void hovered(std::optional<QPoint> pixel);
    void selectionChanged();
    void lineChanged();
    /// On a pixel, without a drag.
    void clicked(const QPoint& pixel);
    void viewChanged();

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    const ColoredPlane& shown() const { return secondShown_ ? second_ : plane_; }
    void onChanged();
    bool isStale() const;
    void refreshColors();
    void drawFrame(QPainter& painter, const QRectF& pixels) const;
    void drawOutlines(QPainter& painter) const;
    void drawLineTo(const QPointF& from, const QPointF& to);
    void setLine(const std::optional<QLine>& line);
    void printValues(QPainter& painter) const;
    void onPlaced();
    void zoomAt(const QPointF& point, double zoom);
    void select(const QPointF& from, const QPointF& to);
    void moveCursor(const QPoint& step, bool selecting);
    bool handleKey(int key, Qt::KeyboardModifiers modifiers);

    ColoredPlane plane_, second_;
    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    QString hint_;
    std::vector<QRectF> outlines_;
    std::vector<IsoLine> isoLines_;
    std::vector<QPoint> spots_;
    bool lineMode_ = false;
    std::optional<QLine> line_;
    bool secondShown_ = false;
    bool awaitsColors_ = false;
    unsigned revision_ = 0; ///< of values, colours and marks
    LatestTask colorTask_;
    std::optional<double> wipe_;
    CanvasPlacement placement_;
    PixelSelection chosen_;
    std::optional<QPointF> panFrom_, selectFrom_;
};

} // namespace smat::gui
