#include "gui/database/AngleCurve.h"

#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "gui/widgets/Theme.h"

namespace smat::gui {

AngleCurve::AngleCurve(QWidget* parent) : QWidget(parent) {
    setObjectName("angleCurve");
    setMinimumSize(200, 130);
    setToolTip(tr("Emission against the angle between the surface's normal and the sensor"));
}

void AngleCurve::setFactor(double factor) {
    factor_ = factor;
    update();
}

void AngleCurve::paintEvent(QPaintEvent*) {
    const PlotStyle style = PlotStyle::screen(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    painter.setFont(small);
    const QRectF area = QRectF(rect()).adjusted(52, 10, -14, -36);
    painter.setPen(QPen(style.grid, 1.0));
    painter.setBrush(style.canvas);
    painter.drawRect(area);
    painter.setPen(style.text);
    for (const int angle : {0, 30, 60, 90}) {
        const double x = area.left() + area.width() * angle / 90.0;
        painter.drawText(QRectF(x - 20, area.bottom() + 2, 40, 15), Qt::AlignCenter,
                         QStringLiteral("%1°").arg(angle));
    }
    painter.drawText(QRectF(area.left(), area.bottom() + 17, area.width(), 16), Qt::AlignCenter,
                     tr("viewing angle"));
    for (const double level : {0.0, 0.5, 1.0})
        painter.drawText(QRectF(16, area.bottom() - level * area.height() - 8, 31, 16),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(level));

    painter.save();
    painter.translate(9.0, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, -8.0, area.height(), 16.0), Qt::AlignCenter,
                     tr("part of that along the normal"));
    painter.restore();

    const auto curve = [&](double factor) {
        QPainterPath path;
        for (int i = 0; i <= 90; ++i) {
            const double cosine = i == 90 ? 0.0 : std::cos(i * std::numbers::pi / 180.0);
            const double value = factor == 0.0 ? 1.0 : std::pow(cosine, factor);
            const QPointF at(area.left() + area.width() * i / 90.0,
                             area.bottom() - value * area.height());
            i == 0 ? path.moveTo(at) : path.lineTo(at);
        }
        return path;
    };
    painter.setBrush(Qt::NoBrush);
    for (const double factor : {0.0, 0.25, 1.0, 3.0}) {
        painter.setPen(QPen(style.faintText, 1.0, Qt::DotLine));
        painter.drawPath(curve(factor));
    }
    painter.setPen(QPen(style.curve(0), 2.2));
    painter.drawPath(curve(factor_));
}

} // namespace smat::gui
