#include "gui/view/SeamedDrawing.h"

#include <QPainter>
#include <QPainterPath>

#include "gui/plot/CurveDrawing.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

QColor faded(QColor color, float alpha) {
    color.setAlphaF(alpha);
    return color;
}

void drawSeamed(QPainter& painter, const QLineF& line, const QColor& color, double width_px,
                bool dark, Qt::PenStyle style) {
    // A line that ends near the eye is millions of pixels long, all of which would be stroked.
    const double margin_px = width_px + 2.4;
    const QRectF seen = painter.transform().inverted().mapRect(QRectF(painter.window()));
    const auto parts = clipped(QPolygonF{line.p1(), line.p2()},
                               seen.adjusted(-margin_px, -margin_px, margin_px, margin_px));
    painter.setPen(
        QPen(faded(colors::overlayPaper(dark), 0.55F), margin_px, Qt::SolidLine, Qt::RoundCap));
    for (const QPolygonF& part : parts)
        painter.drawPolyline(part);
    painter.setPen(QPen(color, width_px, style, Qt::RoundCap));
    for (const QPolygonF& part : parts)
        painter.drawPolyline(part);
}

void drawSeamedPath(QPainter& painter, const QPolygonF& corners, const QColor& color,
                    double width_px, bool dark) {
    painter.setPen(QPen(faded(colors::overlayPaper(dark), 0.55F), width_px + 2.4, Qt::SolidLine,
                        Qt::RoundCap));
    painter.drawPolyline(corners);
    painter.setPen(QPen(color, width_px, Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(corners);
}

void drawArrowHead(QPainter& painter, const QLineF& line, const QColor& color, double size_px,
                   bool dark) {
    if (line.length() < 1.0)
        return;
    const QPointF ahead = (line.p2() - line.p1()) / line.length();
    const QPointF aside(-ahead.y(), ahead.x());
    const QPolygonF head{{line.p2() + ahead * size_px * 1.6, line.p2() + aside * size_px,
                          line.p2() - aside * size_px}};
    painter.setPen(QPen(faded(colors::overlayPaper(dark), 0.55F), 2.4));
    painter.setBrush(color);
    painter.drawPolygon(head);
    painter.setBrush(Qt::NoBrush);
}

void drawSeamedText(QPainter& painter, const QPointF& middle, const QString& text,
                    const QColor& color, bool dark) {
    const QFontMetricsF metrics(painter.font());
    QPainterPath path;
    path.addText(middle - QPointF(metrics.horizontalAdvance(text) / 2.0,
                                  (metrics.descent() - metrics.ascent()) / 2.0),
                 painter.font(), text);
    painter.strokePath(path, QPen(faded(colors::overlayPaper(dark), 0.75F), 3.0, Qt::SolidLine,
                                  Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, color);
}

} // namespace smat::gui
