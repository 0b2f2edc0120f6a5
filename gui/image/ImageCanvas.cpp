#include "gui/image/ImageCanvas.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "gui/Theme.h"

namespace smat::gui {

ImageCanvas::ImageCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName("imageCanvas");
    setMouseTracking(true);
    setMinimumSize(200, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::CrossCursor);
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
}

void ImageCanvas::setPlane(int width, int height, const std::vector<float>& values) {
    const bool sameSize = width == width_ && height == height_;
    width_ = width;
    height_ = height;
    values_ = values;
    recolor();
    if (!sameSize)
        fit();
}

void ImageCanvas::setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    map_ = &map;
    limits_ = limits;
    recolor();
}

void ImageCanvas::recolor() {
    picture_ = QImage(width_, height_, QImage::Format_RGB32);
    std::size_t next = 0;
    for (int y = 0; y < height_; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture_.scanLine(y));
        for (int x = 0; x < width_; ++x) {
            const irsg::Rgb color = map_->color(static_cast<double>(values_[next++]), limits_);
            line[x] = qRgb(color.red, color.green, color.blue);
        }
    }
    update();
}

void ImageCanvas::fit() {
    fitted_ = true;
    if (width_ == 0)
        return;
    zoom_ =
        std::min(static_cast<double>(width()) / width_, static_cast<double>(height()) / height_);
    corner_ = QPointF(width() - zoom_ * width_, height() - zoom_ * height_) / 2.0;
    update();
}

void ImageCanvas::setZoom(double windowPixelsPerPixel) {
    const QPointF middle(width() / 2.0, height() / 2.0);
    const double zoom = std::clamp(windowPixelsPerPixel, 0.02, 200.0);
    corner_ = middle + (corner_ - middle) * (zoom / zoom_);
    zoom_ = zoom;
    fitted_ = false;
    update();
}

std::optional<QPoint> ImageCanvas::pixelAt(const QPointF& point) const {
    const QPointF p = (point - corner_) / zoom_;
    const QPoint pixel(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
    if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= width_ || pixel.y() >= height_)
        return std::nullopt;
    return pixel;
}

QPointF ImageCanvas::widgetPoint(const QPointF& imagePoint) const {
    return corner_ + imagePoint * zoom_;
}

void ImageCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), isDark(palette()) ? QColor("#14161a") : QColor("#e3e6eb"));
    if (picture_.isNull())
        return;
    // Enlarged pixels stay squares; only a reduced picture is smoothed.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ * devicePixelRatioF() < 1.0);
    painter.drawImage(QRectF(corner_, QSizeF(picture_.size()) * zoom_), picture_);
    if (selection_) {
        const QRectF box(widgetPoint(QPointF(selection_->x, selection_->y)),
                         QSizeF(selection_->width, selection_->height) * zoom_);
        painter.setPen(QPen(Qt::black, 3.0));
        painter.drawRect(box);
        painter.setPen(QPen(QColor("#ffd43b"), 1.4));
        painter.drawRect(box);
    }
}

void ImageCanvas::resizeEvent(QResizeEvent*) {
    if (fitted_)
        fit();
}

void ImageCanvas::wheelEvent(QWheelEvent* event) {
    const double zoom =
        std::clamp(zoom_ * std::pow(1.2, event->angleDelta().y() / 120.0), 0.02, 200.0);
    const QPointF cursor = event->position();
    corner_ = cursor + (corner_ - cursor) * (zoom / zoom_);
    zoom_ = zoom;
    fitted_ = false;
    update();
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
        corner_ += event->position() - *panFrom_;
        panFrom_ = event->position();
        fitted_ = false;
        update();
    }
    if (selectFrom_)
        select(*selectFrom_, event->position());
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
    emit hovered(std::nullopt);
}

void ImageCanvas::select(const QPointF& from, const QPointF& to) {
    const QRectF box = QRectF((from - corner_) / zoom_, (to - corner_) / zoom_).normalized();
    const auto before = selection_;
    const int left = std::max(0, static_cast<int>(std::floor(box.left())));
    const int top = std::max(0, static_cast<int>(std::floor(box.top())));
    const int right = std::min(width_, static_cast<int>(std::ceil(box.right())));
    const int bottom = std::min(height_, static_cast<int>(std::ceil(box.bottom())));
    // A click without a drag takes the selection away.
    const bool dragged = std::abs(to.x() - from.x()) + std::abs(to.y() - from.y()) > 4.0;
    selection_.reset();
    if (dragged && right > left && bottom > top)
        selection_ = irsg::PixelRectangle{left, top, right - left, bottom - top};
    if (selection_ != before) {
        update();
        emit selectionChanged();
    }
}

} // namespace smat::gui
