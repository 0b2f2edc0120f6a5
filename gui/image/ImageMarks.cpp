#include "gui/image/ImageMarks.h"

#include <utility>

#include <QPainter>

#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

namespace {

const QPointF middleOfPixel(0.5, 0.5);

} // namespace

void drawMarked(QPainter& painter, const std::function<void()>& draw) {
    for (const auto& [color, width] :
         {std::pair{colors::imageMarkSeam(), 3.0}, {colors::imageMark(), 1.4}}) {
        painter.setPen(QPen(color, width));
        draw();
    }
}

void drawSpots(QPainter& painter, const std::vector<QPoint>& spots, const ImagePlace& place) {
    constexpr double ring_px = 7.0;
    const QFontMetricsF metrics(painter.font());
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const QPointF at = place(QPointF(spots[i]) + middleOfPixel);
        drawMarked(painter, [&] { painter.drawEllipse(at, ring_px, ring_px); });
        const QString number = QString::number(i + 1);
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(number) + 6.0, metrics.height());
        box.moveBottomLeft(at + QPointF(ring_px, -ring_px));
        painter.fillRect(box, colors::imageMarkSeam());
        painter.setPen(colors::imageMark());
        painter.drawText(box, Qt::AlignCenter, number);
    }
}

void drawProfileLine(QPainter& painter, const QLine& line, const QSize& image,
                     const ImagePlace& place) {
    std::vector<QLineF> lines{QLineF(line.p1() + middleOfPixel, line.p2() + middleOfPixel)};
    if (line.p1() == line.p2()) {
        const QPointF at = line.p1() + middleOfPixel;
        lines = {QLineF(0.0, at.y(), image.width(), at.y()),
                 QLineF(at.x(), 0.0, at.x(), image.height())};
    }
    drawMarked(painter, [&] {
        for (const QLineF& one : lines)
            painter.drawLine(place(one.p1()), place(one.p2()));
    });
}

} // namespace smat::gui
