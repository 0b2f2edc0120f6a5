#pragma once

#include <QObject>

namespace smat::gui {

/// Keeps the wheel of the mouse from changing fields that it merely passes: over a box of choices,
/// a box of numbers or a slider in a form that scrolls, the wheel scrolls the form; anywhere else
/// it changes the one alone that has the focus. Lists that are open and views have their wheel as
/// ever. Installed once, on the application.
class WheelGuard : public QObject {
    Q_OBJECT

  public:
    explicit WheelGuard(QObject* parent) : QObject(parent) {}
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace smat::gui
