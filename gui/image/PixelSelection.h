#pragma once

#include <optional>

#include <QPoint>
#include <QRectF>
#include <QSize>

#include "irsg/image/ImageStatistics.h"

namespace smat::gui {

/// What a person has chosen of an image: a rectangle of pixels, and the pixel that is read.
class PixelSelection {
  public:
    /// Nothing is chosen of another image.
    void setImage(const QSize& pixels);
    void clear();
    bool isEmpty() const { return !rectangle_ && !cursor_; }

    const std::optional<irsg::PixelRectangle>& rectangle() const { return rectangle_; }
    /// What lies outside of the image is cut off.
    void setRectangle(const std::optional<irsg::PixelRectangle>& rectangle);
    /// All pixels that a drag touched, in image pixels; none where it was a click. Whether the
    /// rectangle is another now.
    bool drag(const std::optional<QRectF>& box);

    std::optional<QPoint> cursor() const { return cursor_; }
    /// Whether it is another now.
    bool setCursor(std::optional<QPoint> pixel);
    /// Moves the cursor, which begins at `middle`; with `selecting` the rectangle goes from where
    /// that began to here.
    void step(const QPoint& way, const QPoint& middle, bool selecting);

  private:
    QSize image_;
    std::optional<irsg::PixelRectangle> rectangle_;
    std::optional<QPoint> cursor_, anchor_;
};

} // namespace smat::gui
