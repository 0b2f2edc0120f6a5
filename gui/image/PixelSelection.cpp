#include "gui/image/PixelSelection.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace smat::gui {

void PixelSelection::setImage(const QSize& pixels) {
    image_ = pixels;
    clear();
}

void PixelSelection::clear() {
    rectangle_.reset();
    cursor_.reset();
    anchor_.reset();
}

void PixelSelection::setRectangle(const std::optional<irsg::PixelRectangle>& rectangle) {
    rectangle_.reset();
    if (!rectangle)
        return;
    const QRect inside = QRect(rectangle->x, rectangle->y, rectangle->width, rectangle->height) &
                         QRect(QPoint(), image_);
    if (!inside.isEmpty())
        rectangle_ = irsg::PixelRectangle{inside.x(), inside.y(), inside.width(), inside.height()};
}

bool PixelSelection::drag(const std::optional<QRectF>& box) {
    const auto before = rectangle_;
    anchor_.reset();
    std::optional<irsg::PixelRectangle> chosen;
    if (box) {
        const int left = static_cast<int>(std::floor(std::max(box->left(), -1.0)));
        const int top = static_cast<int>(std::floor(std::max(box->top(), -1.0)));
        const double right = std::min(box->right(), image_.width() + 1.0);
        const double bottom = std::min(box->bottom(), image_.height() + 1.0);
        chosen = irsg::PixelRectangle{left, top, static_cast<int>(std::ceil(right)) - left,
                                      static_cast<int>(std::ceil(bottom)) - top};
    }
    setRectangle(chosen);
    return rectangle_ != before;
}

bool PixelSelection::setCursor(std::optional<QPoint> pixel) {
    return std::exchange(cursor_, pixel) != pixel;
}

void PixelSelection::step(const QPoint& way, const QPoint& middle, bool selecting) {
    const QPoint before = cursor_.value_or(middle);
    const QPoint to(std::clamp(before.x() + (cursor_ ? way.x() : 0), 0, image_.width() - 1),
                    std::clamp(before.y() + (cursor_ ? way.y() : 0), 0, image_.height() - 1));
    cursor_ = to;
    if (!selecting) {
        anchor_.reset();
        return;
    }
    const QPoint from = anchor_.value_or(before);
    anchor_ = from;
    rectangle_ =
        irsg::PixelRectangle{std::min(from.x(), to.x()), std::min(from.y(), to.y()),
                             std::abs(from.x() - to.x()) + 1, std::abs(from.y() - to.y()) + 1};
}

} // namespace smat::gui
