#include "gui/image/IsoLine.h"

#include <utility>

#include <QPainter>

#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

void drawIsoLines(QPainter& painter, const std::vector<IsoLine>& lines,
                  const std::function<QPointF(const QPointF&)>& place) {
    for (const auto& [color, width] :
         {std::pair{colors::outlineSeam(), 2.4}, {colors::outline(), 1.0}}) {
        painter.setPen(QPen(color, width));
        for (const IsoLine& line : lines)
            for (const QLineF& part : line.parts)
                painter.drawLine(place(part.p1()), place(part.p2()));
    }
    const QFontMetricsF metrics(painter.font());
    for (const IsoLine& line : lines) {
        if (line.parts.empty())
            continue;
        const QPointF at = place(line.parts[line.parts.size() / 2].p1());
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(line.label) + 6.0, metrics.height());
        box.moveCenter(at);
        painter.fillRect(box, colors::outlineSeam());
        painter.setPen(colors::outline());
        painter.drawText(box, Qt::AlignCenter, line.label);
    }
}

} // namespace smat::gui
