#pragma once

#include <optional>

#include <QObject>
#include <QPointF>
#include <QRectF>

class QMouseEvent;
class QRubberBand;
class QWidget;

namespace smat::gui {

/// While it is on, the left button draws a box over a widget in place of what the widget does with
/// it; the other buttons and the wheel are the widget's own.
class BoxMouse : public QObject {
    Q_OBJECT

  public:
    explicit BoxMouse(QWidget* over);
    void setOn(bool on);

  signals:
    void boxed(const QRectF& box, Qt::KeyboardModifiers modifiers);
    /// No box was drawn.
    void clicked(const QPointF& point, Qt::KeyboardModifiers modifiers);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void release(const QMouseEvent& event);

    QWidget* over_;
    QRubberBand* band_;
    bool isOn_ = false;
    std::optional<QPointF> from_;
};

} // namespace smat::gui
