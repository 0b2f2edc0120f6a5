#pragma once

#include <functional>

#include <QWidget>

class QPainter;

namespace smat::gui {

/// A transparent sheet over a plot's canvas, so that the crosshair and the zoom rectangle follow
/// the mouse without drawing the plot anew. Grows with its parent and lets every event through.
class CrosshairOverlay : public QWidget {
  public:
    CrosshairOverlay(QWidget* canvas, std::function<void(QPainter&)> paint);

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    std::function<void(QPainter&)> paint_;
};

/// One line of a read-out box.
struct ReadoutLine {
    QColor color; ///< of its mark; invalid for none
    QString text;
};
/// Draws a rounded box with the lines beside `anchor`, kept inside `area`.
void drawReadoutBox(QPainter& painter, const QPointF& anchor, const QRectF& area,
                    const std::vector<ReadoutLine>& lines, const QColor& background,
                    const QColor& frame, const QColor& text);

} // namespace smat::gui
