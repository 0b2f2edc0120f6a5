#include "gui/plot/CrosshairOverlay.h"

#include <algorithm>

#include <QEvent>
#include <QPainter>

namespace smat::gui {

CrosshairOverlay::CrosshairOverlay(QWidget* canvas, std::function<void(QPainter&)> paint)
    : QWidget(canvas), paint_(std::move(paint)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    canvas->installEventFilter(this);
    resize(canvas->size());
}

void CrosshairOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_(painter);
}

bool CrosshairOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize)
        resize(parentWidget()->size());
    return QWidget::eventFilter(watched, event);
}

void drawReadoutBox(QPainter& painter, const QPointF& anchor, const QRectF& area,
                    const std::vector<ReadoutLine>& lines, const QColor& background,
                    const QColor& frame, const QColor& text) {
    constexpr double padding = 7.0;
    constexpr double mark = 14.0;
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const auto& line : lines) {
        const double indent = line.color.isValid() ? mark : 0.0;
        width = std::max(width, metrics.horizontalAdvance(line.text) + indent);
    }
    const double height = metrics.lineSpacing() * static_cast<double>(lines.size());
    QRectF box(0.0, 0.0, width + 2.0 * padding, height + 2.0 * padding);

    // To the right of the anchor, or to its left where the right edge is near.
    box.moveTopLeft(anchor + QPointF(14.0, 14.0));
    if (box.right() > area.right() - 2.0)
        box.moveRight(anchor.x() - 14.0);
    if (box.bottom() > area.bottom() - 2.0)
        box.moveBottom(anchor.y() - 14.0);
    box.moveLeft(std::max(box.left(), area.left() + 2.0));
    box.moveTop(std::max(box.top(), area.top() + 2.0));

    QColor sheet = background;
    sheet.setAlphaF(0.92F);
    painter.setPen(frame);
    painter.setBrush(sheet);
    painter.drawRoundedRect(box, 5.0, 5.0);

    double y = box.top() + padding;
    for (const auto& line : lines) {
        double x = box.left() + padding;
        if (line.color.isValid()) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(line.color);
            painter.drawEllipse(QPointF(x + 4.0, y + metrics.lineSpacing() * 0.5), 4.0, 4.0);
            x += mark;
        }
        painter.setPen(text);
        painter.drawText(QPointF(x, y + metrics.ascent()), line.text);
        y += metrics.lineSpacing();
    }
}

} // namespace smat::gui
