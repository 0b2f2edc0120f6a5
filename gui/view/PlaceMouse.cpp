#include "gui/view/PlaceMouse.h"

#include <QMouseEvent>
#include <QWidget>

namespace smat::gui {

PlaceMouse::PlaceMouse(QWidget* view, std::function<std::optional<Seen>()> seen)
    : QObject(view), view_(view), seen_(std::move(seen)) {
    view->installEventFilter(this);
}

void PlaceMouse::light(std::optional<PlaceHandle> handle) {
    if (handle == lit_)
        return;
    // The view has a cursor of its own only while a box is drawn.
    handle ? view_->setCursor(Qt::PointingHandCursor) : view_->unsetCursor();
    lit_ = handle;
    emit litChanged();
}

void PlaceMouse::drop() {
    if (!dragged_)
        return;
    dragged_.reset();
    emit ended();
    emit litChanged();
}

bool PlaceMouse::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    if (type == QEvent::Leave && !dragged_)
        light(std::nullopt);
    if (type == QEvent::MouseMove)
        return move(static_cast<const QMouseEvent&>(*event));
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease)
        return QObject::eventFilter(watched, event);
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (mouse.button() != Qt::LeftButton)
        return dragged_.has_value();
    if (type == QEvent::MouseButtonRelease) {
        if (!dragged_)
            return false;
        drop();
        return true;
    }
    const auto seen = seen_();
    const auto handle = seen && mouse.modifiers() == Qt::NoModifier
                            ? seen->handles.at(mouse.position(), seen->projection)
                            : std::nullopt;
    if (!handle)
        return false;
    light(handle);
    dragged_ = handle;
    last_ = mouse.position();
    change_ = 0.0;
    emit begun(*handle);
    return true;
}

bool PlaceMouse::move(const QMouseEvent& event) {
    const auto seen = seen_();
    if (!dragged_) {
        if (event.buttons() == Qt::NoButton)
            light(seen ? seen->handles.at(event.position(), seen->projection) : std::nullopt);
        return false;
    }
    if (!seen) {
        drop();
        return true;
    }
    // Bit by bit, so that a ring may be turned by more than half a turn.
    if (const auto bit =
            seen->handles.dragged(*dragged_, last_, event.position(), seen->projection)) {
        change_ += *bit;
        last_ = event.position();
        emit dragged(*dragged_, change_);
    }
    return true;
}

} // namespace smat::gui

#include "moc_PlaceMouse.cpp"
