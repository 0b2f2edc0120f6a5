#include "gui/image/ImageCanvas.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "gui/image/ImageMarks.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {
namespace {

constexpr double wheelStep = 1.2, keyStep = 1.5;
constexpr int printedDigits = 4;
constexpr double leastDrag_px = 4.0;

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
        isoLines_.clear();
        spots_.clear();
        line_.reset();
        placement_.setImage({width, height});
        chosen_.setImage({width, height});
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
    isoLines_.clear();
    spots_.clear();
    line_.reset();
    awaitsColors_ = false;
    colorTask_.cancel();
    placement_.setImage({});
    chosen_.setImage({});
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

void ImageCanvas::setIsoLines(std::vector<IsoLine> lines) {
    if (lines == isoLines_)
        return;
    isoLines_ = std::move(lines);
    update();
}

void ImageCanvas::setSpots(std::vector<QPoint> spots) {
    spots_ = std::move(spots);
    update();
}

void ImageCanvas::setLineMode(bool on) {
    lineMode_ = on;
    setLine(std::nullopt);
}

void ImageCanvas::setLine(const std::optional<QLine>& line) {
    if (line == line_)
        return;
    line_ = line;
    update();
    emit lineChanged();
}

void ImageCanvas::drawLineTo(const QPointF& from, const QPointF& to) {
    const auto pixelOf = [this](const QPointF& point) {
        const QPointF at = placement_.inImage(point);
        return QPoint(std::clamp(static_cast<int>(std::floor(at.x())), 0, plane_.width() - 1),
                      std::clamp(static_cast<int>(std::floor(at.y())), 0, plane_.height() - 1));
    };
    if (!hasImage())
        return;
    const bool isDrag = (to - from).manhattanLength() > leastDrag_px;
    if (!isDrag && !pixelAt(from))
        setLine(std::nullopt);
    else
        setLine(QLine(pixelOf(from), pixelOf(isDrag ? to : from)));
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

void ImageCanvas::onPlaced() {
    update();
    emit viewChanged();
}

void ImageCanvas::fit() {
    if (placement_.fit(size()))
        onPlaced();
}

void ImageCanvas::zoomAt(const QPointF& point, double zoom) {
    placement_.zoomAt(point, zoom);
    onPlaced();
}

void ImageCanvas::setZoom(double windowPixelsPerPixel) {
    zoomAt(QPointF(width() / 2.0, height() / 2.0), windowPixelsPerPixel);
}

void ImageCanvas::showActualSize() {
    setZoom(1.0 / devicePixelRatioF());
}

void ImageCanvas::setView(const CanvasView& view) {
    placement_.setView(view, size());
    update();
}

void ImageCanvas::centreOn(const QPoint& pixel, double zoom) {
    placement_.centreOn(pixel, zoom, size());
    onPlaced();
}

double ImageCanvas::printingZoom() const {
    return QFontMetricsF(font()).horizontalAdvance("-1.234e-05") + 6.0;
}

void ImageCanvas::drawFrame(QPainter& painter, const QRectF& pixels) const {
    const QRectF box = placement_.inRoom(pixels);
    painter.setBrush(Qt::NoBrush);
    drawMarked(painter, [&] { painter.drawRect(box); });
}

void ImageCanvas::drawOutlines(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, width] :
         {std::pair{colors::outlineSeam(), 3.0}, {colors::outline(), 1.0}}) {
        painter.setPen(QPen(color, width));
        for (const QRectF& outline : outlines_)
            painter.drawRect(placement_.inRoom(outline));
    }
}

void ImageCanvas::printValues(QPainter& painter) const {
    const QRectF seen = placement_.imageInRoom() & QRectF(rect());
    const auto first = pixelAt(seen.topLeft() + QPointF(0.01, 0.01));
    const auto last = pixelAt(seen.bottomRight() - QPointF(0.01, 0.01));
    if (!first || !last)
        return;
    const bool wiping = wipe_ && !second_.isEmpty();
    for (int y = first->y(); y <= last->y(); ++y)
        for (int x = first->x(); x <= last->x(); ++x) {
            const QRectF box = placement_.inRoom(QRectF(x, y, 1.0, 1.0));
            const bool right = wiping && box.center().x() >= *wipe_ * width();
            const ColoredPlane& plane = right ? second_ : shown();
            painter.setPen(colors::textUpon(plane.shownColorAt(x, y)));
            painter.drawText(box, Qt::AlignCenter, printed(static_cast<double>(plane.at(x, y))));
        }
}

void ImageCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), colors::imageSurround(palette()));
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
    shown().draw(painter, placement_.imageInRoom(), rect(), devicePixelRatioF());
    if (wipe_ && !second_.isEmpty()) {
        // The second plane from the line on.
        const double line = *wipe_ * width();
        const QRectF right(line, 0.0, width() - line, height());
        painter.save();
        painter.setClipRect(right);
        painter.fillRect(right, colors::imageSurround(palette()));
        second_.draw(painter, placement_.imageInRoom(), right, devicePixelRatioF());
        painter.restore();
        drawMarked(painter, [&] { painter.drawLine(QPointF(line, 0.0), QPointF(line, height())); });
    }
    if (zoom() >= printingZoom())
        printValues(painter);
    drawOutlines(painter);
    const ImagePlace place = [this](const QPointF& point) { return placement_.inRoom(point); };
    if (!isoLines_.empty())
        drawIsoLines(painter, isoLines_, place);
    drawSpots(painter, spots_, place);
    if (line_)
        drawProfileLine(painter, *line_, {plane_.width(), plane_.height()}, place);
    if (const auto& box = chosen_.rectangle())
        drawFrame(painter, QRectF(box->x, box->y, box->width, box->height));
    if (const auto cursor = chosen_.cursor()) {
        // A pixel too small to be seen has a box of a few window pixels around it.
        const double margin = zoom() >= 6.0 ? 0.0 : (6.0 / zoom() - 1.0) / 2.0;
        const QRectF pixel(cursor->x(), cursor->y(), 1.0, 1.0);
        drawFrame(painter, pixel.adjusted(-margin, -margin, margin, margin));
    }
}

void ImageCanvas::resizeEvent(QResizeEvent*) {
    if (placement_.isFitted())
        fit();
}

void ImageCanvas::wheelEvent(QWheelEvent* event) {
    zoomAt(event->position(), zoom() * std::pow(wheelStep, event->angleDelta().y() / 120.0));
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
        placement_.moveBy(event->position() - *panFrom_);
        onPlaced();
        panFrom_ = event->position();
    }
    if (selectFrom_)
        select(*selectFrom_, event->position());
    setCursorPixel(std::nullopt);
    emit hovered(pixelAt(event->position()));
}

void ImageCanvas::mouseReleaseEvent(QMouseEvent* event) {
    const std::optional<QPointF> from = selectFrom_;
    if (from)
        select(*from, event->position());
    panFrom_.reset();
    selectFrom_.reset();
    if (from && (event->position() - *from).manhattanLength() <= leastDrag_px)
        if (const auto pixel = pixelAt(*from))
            emit clicked(*pixel);
}

void ImageCanvas::mouseDoubleClickEvent(QMouseEvent*) {
    fit();
}

void ImageCanvas::leaveEvent(QEvent*) {
    emit hovered(cursorPixel());
}

void ImageCanvas::select(const QPointF& from, const QPointF& to) {
    if (lineMode_) {
        drawLineTo(from, to);
        return;
    }
    // A click without a drag takes the selection away.
    std::optional<QRectF> box;
    if ((to - from).manhattanLength() > leastDrag_px)
        box = QRectF(placement_.inImage(from), placement_.inImage(to)).normalized();
    const bool hasChanged = chosen_.drag(box);
    update();
    if (hasChanged)
        emit selectionChanged();
}

void ImageCanvas::setSelection(const std::optional<irsg::PixelRectangle>& selection) {
    chosen_.setRectangle(selection);
    update();
}

void ImageCanvas::setCursorPixel(std::optional<QPoint> pixel) {
    if (chosen_.setCursor(pixel))
        update();
}

void ImageCanvas::moveCursor(const QPoint& step, bool selecting) {
    const QPointF centre = view().centre;
    const QPoint before = cursorPixel().value_or(line_ ? line_->p2() : QPoint(-1, -1));
    chosen_.step(step, {static_cast<int>(centre.x()), static_cast<int>(centre.y())},
                 selecting && !lineMode_);
    // The pixel stays in sight.
    const QPoint to = *cursorPixel();
    if (!rect().contains(widgetPoint(QPointF(to) + QPointF(0.5, 0.5)).toPoint()))
        centreOn(to, zoom());
    if (lineMode_ && selecting && before.x() >= 0)
        setLine(QLine(line_ ? line_->p1() : before, to));
    else if (lineMode_)
        setLine(QLine(to, to));
    else if (selecting)
        emit selectionChanged();
    update();
    emit hovered(to);
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
        if (control) {
            placement_.moveBy(QPointF(step) * -40.0);
            onPlaced();
        } else {
            moveCursor(step, shift);
        }
        return true;
    }
    if (control)
        return false;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        setZoom(zoom() * keyStep);
        return true;
    case Qt::Key_Minus:
        setZoom(zoom() / keyStep);
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_A:
        showActualSize();
        return true;
    case Qt::Key_Escape:
        if (chosen_.isEmpty() && !line_)
            return false;
        chosen_.clear();
        setLine(std::nullopt);
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
        const bool clears = key->key() == Qt::Key_Escape && (!chosen_.isEmpty() || line_);
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

#include "moc_ImageCanvas.cpp"
