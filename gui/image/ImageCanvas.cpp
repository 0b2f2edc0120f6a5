#include "gui/image/ImageCanvas.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "gui/Theme.h"

namespace smat::gui {
namespace {

constexpr double leastZoom = 0.02, largestZoom = 200.0, wheelStep = 1.2, keyStep = 1.5;
constexpr int printedDigits = 4;

QString printed(double value) {
    return std::isnan(value) ? QStringLiteral("NaN") : QString::number(value, 'g', printedDigits);
}

} // namespace

ImageCanvas::ImageCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName("imageCanvas");
    setMouseTracking(true);
    setMinimumSize(200, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::CrossCursor);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
}

void ImageCanvas::setPlane(int width, int height, SharedValues values,
                           const std::optional<LightPlanes>& light) {
    const bool sameSize = width == plane_.width() && height == plane_.height();
    plane_.setValues(width, height, std::move(values));
    plane_.setColors(*map_, limits_);
    if (light)
        plane_.setLight(*light);
    if (!sameSize) {
        colorTask_.cancel();
        second_ = {};
        secondShown_ = false;
        cursor_.reset();
        selectAnchor_.reset();
        selection_.reset();
        fit();
    }
    onChanged();
}

void ImageCanvas::setPlane(int width, int height, const std::vector<float>& values) {
    setPlane(width, height, std::make_shared<const std::vector<float>>(values));
}

void ImageCanvas::clear() {
    plane_ = second_ = {};
    secondShown_ = false;
    awaitsColors_ = false;
    colorTask_.cancel();
    cursor_.reset();
    selection_.reset();
    onChanged();
}

void ImageCanvas::forgetPicture() {
    colorTask_.cancel();
    plane_.forgetPicture();
    second_.forgetPicture();
    update();
}

void ImageCanvas::setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    map_ = &map;
    limits_ = limits;
    plane_.setColors(map, limits);
    second_.setColors(map, limits);
    awaitsColors_ = false;
    onChanged();
}

void ImageCanvas::setMarks(std::vector<std::uint8_t> marks) {
    plane_.setMarks(std::move(marks));
    onChanged();
}

void ImageCanvas::setOutlines(std::vector<QRectF> outlines) {
    outlines_ = std::move(outlines);
    update();
}

void ImageCanvas::setSecond(SharedValues values) {
    colorTask_.cancel(); // it may have the picture of another one
    second_.forgetPicture();
    second_.setValues(plane_.width(), plane_.height(), std::move(values));
    second_.setColors(*map_, limits_);
    onChanged();
}

void ImageCanvas::onChanged() {
    ++revision_;
    update();
}

bool ImageCanvas::isStale() const {
    return plane_.isStale() || second_.isStale();
}

bool ImageCanvas::isBusy() const {
    return awaitsColors_ || colorTask_.isBusy() || (isVisible() && isStale());
}

void ImageCanvas::refreshColors() {
    if (!isStale() || awaitsColors_ || colorTask_.isBusy())
        return;
    using Planes = std::pair<ColoredPlane, ColoredPlane>;
    const auto work = [first = plane_, second = second_] {
        for (const ColoredPlane* plane : {&first, &second})
            if (plane->isStale())
                plane->color();
        return Planes(first, second);
    };
    if (plane_.pixelCount() <= quickPixels) {
        std::tie(plane_, second_) = work();
        return;
    }
    // Changes that come meanwhile are coloured next; a picture of the last but one is soon enough
    // to be worth showing.
    colorTask_.run<Planes>(work, [this, asked = revision_](const Planes& colored) {
        if (asked == revision_)
            std::tie(plane_, second_) = colored;
        else
            plane_.showPictureOf(colored.first), second_.showPictureOf(colored.second);
        update();
    });
}

void ImageCanvas::setSecondShown(bool shown) {
    secondShown_ = shown && !second_.isEmpty();
    update();
}

void ImageCanvas::setWipe(std::optional<double> fraction) {
    wipe_ = fraction;
    update();
}

void ImageCanvas::place(double zoom, const QPointF& corner, bool fitted) {
    zoom_ = zoom;
    corner_ = corner;
    fitted_ = fitted;
    update();
    emit viewChanged();
}

void ImageCanvas::fit() {
    fitted_ = true;
    if (!hasImage() || width() == 0 || height() == 0)
        return;
    const double zoom = std::min(static_cast<double>(width()) / plane_.width(),
                                 static_cast<double>(height()) / plane_.height());
    place(zoom, QPointF(width() - zoom * plane_.width(), height() - zoom * plane_.height()) / 2.0,
          true);
}

void ImageCanvas::zoomAt(const QPointF& point, double zoom) {
    const double to = std::clamp(zoom, leastZoom, largestZoom);
    place(to, point + (corner_ - point) * (to / zoom_), false);
}

void ImageCanvas::setZoom(double windowPixelsPerPixel) {
    zoomAt(QPointF(width() / 2.0, height() / 2.0), windowPixelsPerPixel);
}

void ImageCanvas::showActualSize() {
    setZoom(1.0 / devicePixelRatioF());
}

CanvasView ImageCanvas::view() const {
    return {zoom_, (QPointF(width() / 2.0, height() / 2.0) - corner_) / zoom_, fitted_};
}

void ImageCanvas::setView(const CanvasView& view) {
    zoom_ = view.zoom;
    corner_ = QPointF(width() / 2.0, height() / 2.0) - view.centre * view.zoom;
    fitted_ = view.fitted;
    update();
}

void ImageCanvas::centreOn(const QPoint& pixel, double zoom) {
    const double to = std::clamp(std::max(zoom, zoom_), leastZoom, largestZoom);
    place(to, QPointF(width() / 2.0, height() / 2.0) - (QPointF(pixel) + QPointF(0.5, 0.5)) * to,
          false);
}

std::optional<QPoint> ImageCanvas::pixelAt(const QPointF& point) const {
    const QPointF p = (point - corner_) / zoom_;
    const QPoint pixel(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= plane_.width() ||
        pixel.y() >= plane_.height())
        return std::nullopt;
    return pixel;
}

QPointF ImageCanvas::widgetPoint(const QPointF& imagePoint) const {
    return corner_ + imagePoint * zoom_;
}

QRectF ImageCanvas::imageRect() const {
    return {corner_, QSizeF(plane_.width() * zoom_, plane_.height() * zoom_)};
}

double ImageCanvas::printingZoom() const {
    return QFontMetricsF(font()).horizontalAdvance("-1.234e-05") + 6.0;
}

void ImageCanvas::drawFrame(QPainter& painter, const QRectF& pixels) const {
    const QRectF box(widgetPoint(pixels.topLeft()), pixels.size() * zoom_);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawRect(box);
    painter.setPen(QPen(QColor("#ffd43b"), 1.4));
    painter.drawRect(box);
}

void ImageCanvas::drawOutlines(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, width] : {std::pair{QColor(0, 0, 0, 150), 3.0}, {Qt::white, 1.0}}) {
        painter.setPen(QPen(color, width));
        for (const QRectF& outline : outlines_)
            painter.drawRect(QRectF(widgetPoint(outline.topLeft()), outline.size() * zoom_));
    }
}

void ImageCanvas::printValues(QPainter& painter) const {
    const QRectF seen = imageRect() & QRectF(rect());
    const auto first = pixelAt(seen.topLeft() + QPointF(0.01, 0.01));
    const auto last = pixelAt(seen.bottomRight() - QPointF(0.01, 0.01));
    if (!first || !last)
        return;
    const bool wiping = wipe_ && !second_.isEmpty();
    for (int y = first->y(); y <= last->y(); ++y)
        for (int x = first->x(); x <= last->x(); ++x) {
            const QRectF box(widgetPoint(QPointF(x, y)), QSizeF(zoom_, zoom_));
            const bool right = wiping && box.center().x() >= *wipe_ * width();
            const ColoredPlane& plane = right ? second_ : shown();
            painter.setPen(plane.shownColorAt(x, y).lightness() > 140 ? QColor("#101010")
                                                                      : QColor("#f4f4f4"));
            painter.drawText(box, Qt::AlignCenter, printed(static_cast<double>(plane.at(x, y))));
        }
}

void ImageCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), isDark(palette()) ? QColor("#14161a") : QColor("#e3e6eb"));
    if (!hasImage()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         hint_);
        return;
    }
    refreshColors();
    if (!shown().hasPicture()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter, tr("Colouring the image…"));
        return;
    }
    shown().draw(painter, imageRect(), rect(), devicePixelRatioF());
    if (wipe_ && !second_.isEmpty()) {
        // The second plane from the line on.
        const double line = *wipe_ * width();
        const QRectF right(line, 0.0, width() - line, height());
        painter.save();
        painter.setClipRect(right);
        painter.fillRect(right, isDark(palette()) ? QColor("#14161a") : QColor("#e3e6eb"));
        second_.draw(painter, imageRect(), right, devicePixelRatioF());
        painter.restore();
        painter.setPen(QPen(Qt::black, 3.0));
        painter.drawLine(QPointF(line, 0.0), QPointF(line, height()));
        painter.setPen(QPen(QColor("#ffd43b"), 1.4));
        painter.drawLine(QPointF(line, 0.0), QPointF(line, height()));
    }
    if (zoom_ >= printingZoom())
        printValues(painter);
    drawOutlines(painter);
    if (selection_)
        drawFrame(painter,
                  QRectF(selection_->x, selection_->y, selection_->width, selection_->height));
    if (cursor_) {
        // A pixel too small to be seen has a box of a few window pixels around it.
        const double margin = zoom_ >= 6.0 ? 0.0 : (6.0 / zoom_ - 1.0) / 2.0;
        const QRectF pixel(cursor_->x(), cursor_->y(), 1.0, 1.0);
        drawFrame(painter, pixel.adjusted(-margin, -margin, margin, margin));
    }
}

void ImageCanvas::resizeEvent(QResizeEvent*) {
    if (fitted_)
        fit();
}

void ImageCanvas::wheelEvent(QWheelEvent* event) {
    zoomAt(event->position(), zoom_ * std::pow(wheelStep, event->angleDelta().y() / 120.0));
}

void ImageCanvas::mousePressEvent(QMouseEvent* event) {
    const bool pan = event->button() == Qt::RightButton || event->button() == Qt::MiddleButton ||
                     (event->modifiers() & Qt::ShiftModifier) != 0;
    if (pan)
        panFrom_ = event->position();
    else if (event->button() == Qt::LeftButton)
        selectFrom_ = event->position();
}

void ImageCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (panFrom_) {
        place(zoom_, corner_ + event->position() - *panFrom_, false);
        panFrom_ = event->position();
    }
    if (selectFrom_)
        select(*selectFrom_, event->position());
    if (cursor_) {
        cursor_.reset();
        update();
    }
    emit hovered(pixelAt(event->position()));
}

void ImageCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (selectFrom_)
        select(*selectFrom_, event->position());
    panFrom_.reset();
    selectFrom_.reset();
}

void ImageCanvas::mouseDoubleClickEvent(QMouseEvent*) {
    fit();
}

void ImageCanvas::leaveEvent(QEvent*) {
    emit hovered(cursor_);
}

void ImageCanvas::select(const QPointF& from, const QPointF& to) {
    const QRectF box = QRectF((from - corner_) / zoom_, (to - corner_) / zoom_).normalized();
    const auto before = selection_;
    // A click without a drag takes the selection away.
    const bool dragged = std::abs(to.x() - from.x()) + std::abs(to.y() - from.y()) > 4.0;
    selectAnchor_.reset();
    std::optional<irsg::PixelRectangle> chosen;
    if (dragged) {
        const int left = static_cast<int>(std::floor(std::max(box.left(), -1.0)));
        const int top = static_cast<int>(std::floor(std::max(box.top(), -1.0)));
        chosen = irsg::PixelRectangle{
            left, top,
            static_cast<int>(std::ceil(std::min(box.right(), plane_.width() + 1.0))) - left,
            static_cast<int>(std::ceil(std::min(box.bottom(), plane_.height() + 1.0))) - top};
    }
    setSelection(chosen);
    if (selection_ != before)
        emit selectionChanged();
}

void ImageCanvas::setSelection(const std::optional<irsg::PixelRectangle>& selection) {
    selection_.reset();
    if (selection) {
        const QRect inside =
            QRect(selection->x, selection->y, selection->width, selection->height) &
            QRect(0, 0, plane_.width(), plane_.height());
        if (!inside.isEmpty())
            selection_ =
                irsg::PixelRectangle{inside.x(), inside.y(), inside.width(), inside.height()};
    }
    update();
}

void ImageCanvas::setCursorPixel(std::optional<QPoint> pixel) {
    if (pixel == cursor_)
        return;
    cursor_ = pixel;
    update();
}

void ImageCanvas::moveCursor(const QPoint& step, bool selecting) {
    const QPoint before = cursor_.value_or(
        QPoint(static_cast<int>(view().centre.x()), static_cast<int>(view().centre.y())));
    const QPoint to(std::clamp(before.x() + (cursor_ ? step.x() : 0), 0, plane_.width() - 1),
                    std::clamp(before.y() + (cursor_ ? step.y() : 0), 0, plane_.height() - 1));
    cursor_ = to;
    // The pixel stays in sight.
    const QPointF at = widgetPoint(QPointF(to) + QPointF(0.5, 0.5));
    if (!rect().contains(at.toPoint()))
        centreOn(to, zoom_);
    if (selecting) {
        if (!selectAnchor_)
            selectAnchor_ = before;
        const QRect whole(
            std::min(selectAnchor_->x(), to.x()), std::min(selectAnchor_->y(), to.y()),
            std::abs(selectAnchor_->x() - to.x()) + 1, std::abs(selectAnchor_->y() - to.y()) + 1);
        selection_ = irsg::PixelRectangle{whole.x(), whole.y(), whole.width(), whole.height()};
        emit selectionChanged();
    } else {
        selectAnchor_.reset();
    }
    update();
    emit hovered(cursor_);
}

bool ImageCanvas::handleKey(int key, Qt::KeyboardModifiers modifiers) {
    if (!hasImage())
        return false;
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    const bool control = modifiers.testFlag(Qt::ControlModifier);
    const QPoint step = key == Qt::Key_Left    ? QPoint(-1, 0)
                        : key == Qt::Key_Right ? QPoint(1, 0)
                        : key == Qt::Key_Up    ? QPoint(0, -1)
                        : key == Qt::Key_Down  ? QPoint(0, 1)
                                               : QPoint();
    if (!step.isNull()) {
        if (control)
            place(zoom_, corner_ - QPointF(step) * 40.0, false);
        else
            moveCursor(step, shift);
        return true;
    }
    if (control)
        return false;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        setZoom(zoom_ * keyStep);
        return true;
    case Qt::Key_Minus:
        setZoom(zoom_ / keyStep);
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_A:
        showActualSize();
        return true;
    case Qt::Key_Escape:
        if (!selection_ && !cursor_)
            return false;
        selection_.reset();
        cursor_.reset();
        selectAnchor_.reset();
        update();
        emit selectionChanged();
        emit hovered(std::nullopt);
        return true;
    default:
        return false;
    }
}

bool ImageCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Plain keys are the image's while it has the focus, whatever the window uses them for.
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool arrow = key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down;
        const bool clears = key->key() == Qt::Key_Escape && (selection_ || cursor_);
        if (arrow || clears) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ImageCanvas::keyPressEvent(QKeyEvent* event) {
    if (!handleKey(event->key(), event->modifiers()))
        QWidget::keyPressEvent(event);
}

} // namespace smat::gui
