#include "gui/plot/PlotNavigator.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <QWidget>

#include "gui/plot/PlotSurface.h"

namespace smat::gui {
namespace {

constexpr double zoomStep = 0.85; // of one notch of the wheel
constexpr double notch = 120.0;   // what Qt calls one notch
constexpr double smallestDrag_px = 5.0;
constexpr double arrowPart = 0.1; // of the canvas

} // namespace

PlotNavigator::PlotNavigator(PlotSurface& surface) : surface_(surface), sheet_(surface.sheet()) {
    overlay_ = new CrosshairOverlay(sheet_, [this](QPainter& painter) { paint(painter); });
    sheet_->setCursor(Qt::CrossCursor);
    sheet_->setMouseTracking(true);
    sheet_->installEventFilter(this);
}

PlotNavigator::~PlotNavigator() {
    delete overlay_;
}

void PlotNavigator::setCrosshairVisible(bool visible) {
    crosshair_ = visible;
    overlay_->update();
}

bool PlotNavigator::handleKey(const QKeyEvent& event) {
    const QSizeF size = sheet_->size();
    const QPointF middle(0.5 * size.width(), 0.5 * size.height());
    const auto changeView = [this](const auto& change) {
        surface_.rememberView();
        change();
    };
    switch (event.key()) {
    case Qt::Key_Backspace:
        surface_.undoZoom();
        return true;
    case Qt::Key_Home:
        surface_.resetView();
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        changeView([&] { surface_.zoomAt(middle, zoomStep); });
        return true;
    case Qt::Key_Minus:
        changeView([&] { surface_.zoomAt(middle, 1.0 / zoomStep); });
        return true;
    case Qt::Key_Left:
        changeView([&] { surface_.panBy({arrowPart * size.width(), 0.0}); });
        return true;
    case Qt::Key_Right:
        changeView([&] { surface_.panBy({-arrowPart * size.width(), 0.0}); });
        return true;
    case Qt::Key_Up:
        changeView([&] { surface_.panBy({0.0, arrowPart * size.height()}); });
        return true;
    case Qt::Key_Down:
        changeView([&] { surface_.panBy({0.0, -arrowPart * size.height()}); });
        return true;
    default:
        return false;
    }
}

bool PlotNavigator::eventFilter(QObject* watched, QEvent* event) {
    if (watched != sheet_ || !handle(*event))
        return QObject::eventFilter(watched, event);
    overlay_->update();
    return true;
}

bool PlotNavigator::handle(QEvent& event) {
    switch (event.type()) {
    case QEvent::Wheel: {
        const auto& wheel = static_cast<QWheelEvent&>(event);
        surface_.rememberView();
        surface_.zoomAt(wheel.position(), std::pow(zoomStep, wheel.angleDelta().y() / notch));
        return true;
    }
    case QEvent::MouseButtonPress:
        press(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::MouseMove:
        move(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::MouseButtonRelease:
        release(static_cast<QMouseEvent&>(event));
        return true;
    case QEvent::MouseButtonDblClick:
        dragStart_.reset();
        surface_.resetView();
        return true;
    case QEvent::ContextMenu:
        return true; // opened by the release of the button, unless that ends a pan
    case QEvent::Leave:
        cursor_.reset();
        overlay_->update();
        emit readoutChanged({});
        return false;
    default:
        return false;
    }
}

void PlotNavigator::press(const QMouseEvent& event) {
    surface_.widget()->setFocus();
    if (event.button() == Qt::LeftButton)
        dragStart_ = event.position();
    if (event.button() == Qt::RightButton) {
        panned_ = false;
        pressedAt_ = panStart_ = event.position();
    }
}

void PlotNavigator::move(const QMouseEvent& event) {
    cursor_ = event.position();
    if (panStart_) {
        // A hand that trembles on a click does not pan.
        const QPointF way = *cursor_ - *pressedAt_;
        if (!panned_ && std::hypot(way.x(), way.y()) < smallestDrag_px)
            return;
        if (!panned_)
            surface_.rememberView();
        panned_ = true;
        surface_.panBy(*cursor_ - *panStart_);
        panStart_ = cursor_;
    }
    emit readoutChanged(surface_.readoutAt(*cursor_));
}

void PlotNavigator::release(const QMouseEvent& event) {
    if (event.button() == Qt::LeftButton && dragStart_) {
        const QRectF box = QRectF(*dragStart_, event.position()).normalized();
        dragStart_.reset();
        if (box.width() > smallestDrag_px && box.height() > smallestDrag_px) {
            surface_.rememberView();
            surface_.zoomTo(box);
        }
    }
    if (event.button() == Qt::RightButton && panStart_) {
        panStart_.reset();
        if (!panned_)
            emit menuRequested(event.globalPosition().toPoint());
    }
}

void PlotNavigator::paint(QPainter& painter) const {
    if (!cursor_ || panStart_)
        return;
    if (dragStart_) {
        QColor fill = surface_.widget()->palette().color(QPalette::Highlight);
        painter.setPen(fill);
        fill.setAlphaF(0.18F);
        painter.setBrush(fill);
        painter.drawRect(QRectF(*dragStart_, *cursor_).normalized());
    } else if (crosshair_) {
        surface_.paintCrosshair(painter, *cursor_);
    }
}

} // namespace smat::gui

#include "moc_PlotNavigator.cpp"
