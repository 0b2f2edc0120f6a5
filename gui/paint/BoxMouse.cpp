#include "gui/paint/BoxMouse.h"

#include <utility>

#include <QGuiApplication>
#include <QLineF>
#include <QMouseEvent>
#include <QRubberBand>
#include <QStyleHints>
#include <QWidget>

namespace smat::gui {

BoxMouse::BoxMouse(QWidget* over)
    : QObject(over), over_(over), band_(new QRubberBand(QRubberBand::Rectangle, over)) {
    over->installEventFilter(this);
}

void BoxMouse::setOn(bool on) {
    if (on == isOn_)
        return;
    isOn_ = on;
    from_.reset();
    band_->hide();
    on ? over_->setCursor(Qt::CrossCursor) : over_->unsetCursor();
}

bool BoxMouse::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    if (!isOn_ || (type != QEvent::MouseButtonPress && type != QEvent::MouseMove &&
                   type != QEvent::MouseButtonRelease && type != QEvent::MouseButtonDblClick))
        return QObject::eventFilter(watched, event);
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (type == QEvent::MouseMove) {
        if (!from_)
            return false;
        band_->setGeometry(QRectF(*from_, mouse.position()).normalized().toAlignedRect());
        band_->show();
        return true;
    }
    if (mouse.button() != Qt::LeftButton)
        return false;
    if (type == QEvent::MouseButtonRelease)
        release(mouse);
    else
        from_ = mouse.position();
    return true;
}

void BoxMouse::release(const QMouseEvent& event) {
    band_->hide();
    const auto from = std::exchange(from_, std::nullopt);
    if (!from)
        return;
    // A hand that trembles still clicks.
    if (QLineF(*from, event.position()).length() <
        QGuiApplication::styleHints()->startDragDistance())
        emit clicked(event.position(), event.modifiers());
    else
        emit boxed(QRectF(*from, event.position()).normalized(), event.modifiers());
}

} // namespace smat::gui

#include "moc_BoxMouse.cpp"
