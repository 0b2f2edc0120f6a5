#include "gui/widgets/WheelGuard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace smat::gui {
namespace {

bool isField(const QObject* watched) {
    return qobject_cast<const QComboBox*>(watched) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(watched) != nullptr ||
           (qobject_cast<const QAbstractSlider*>(watched) != nullptr &&
            qobject_cast<const QScrollBar*>(watched) == nullptr);
}

bool isInScrollingForm(const QWidget& field) {
    for (const QWidget* widget = field.parentWidget(); widget != nullptr && !widget->isWindow();
         widget = widget->parentWidget())
        if (qobject_cast<const QScrollArea*>(widget) != nullptr)
            return true;
    return false;
}

} // namespace

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    // Qt would give the focus to a field that the wheel passes, and then the wheel.
    if (event->type() == QEvent::Polish && isField(watched)) {
        auto* field = static_cast<QWidget*>(watched);
        if (field->focusPolicy() == Qt::WheelFocus)
            field->setFocusPolicy(Qt::StrongFocus);
    }
    if (event->type() != QEvent::Wheel || !watched->isWidgetType())
        return false;
    // The wheel over the line of an editable box reaches that line first.
    auto* field = static_cast<QWidget*>(watched);
    if (!isField(field) && !field->isWindow() && isField(field->parentWidget()))
        field = field->parentWidget();
    if (!isField(field) || (field->hasFocus() && !isInScrollingForm(*field)))
        return false;
    // An event that nobody took goes on to what lies behind the field.
    event->ignore();
    return true;
}

} // namespace smat::gui

#include "moc_WheelGuard.cpp"
