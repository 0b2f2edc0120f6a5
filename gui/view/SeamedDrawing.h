#pragma once

#include <QColor>
#include <QLineF>
#include <QPolygonF>
#include <QString>

class QPainter;

namespace smat::gui {

/// What is drawn over a picture of any colours: lines and words on a seam of paper, so that they
/// are seen before it.
QColor faded(QColor color, float alpha);

void drawSeamed(QPainter& painter, const QLineF& line, const QColor& color, double width_px,
                bool dark, Qt::PenStyle style = Qt::SolidLine);
void drawSeamedPath(QPainter& painter, const QPolygonF& corners, const QColor& color,
                    double width_px, bool dark);
/// At the end of a line.
void drawArrowHead(QPainter& painter, const QLineF& line, const QColor& color, double size_px,
                   bool dark);
void drawSeamedText(QPainter& painter, const QPointF& middle, const QString& text,
                    const QColor& color, bool dark);

} // namespace smat::gui
