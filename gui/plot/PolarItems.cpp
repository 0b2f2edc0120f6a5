#include "gui/plot/PolarItems.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QPainter>
#include <QPainterPath>
#include <QwtScaleMap>
#include <QwtText>

#include "gui/plot/PlotLook.h"

namespace smat::gui {

void GappedPolarCurve::draw(QPainter* painter, const QwtScaleMap& azimuthMap,
                            const QwtScaleMap& radialMap, const QPointF& pole, double,
                            const QRectF&) const {
    const int count = static_cast<int>(dataSize());
    int start = 0;
    while (start < count) {
        while (start < count && !std::isfinite(sample(start).radius()))
            ++start;
        int end = start;
        while (end + 1 < count && std::isfinite(sample(end + 1).radius()))
            ++end;
        if (start < end) {
            QwtPolarCurve::draw(painter, azimuthMap, radialMap, pole, start, end);
        } else if (start < count) {
            const auto point = sample(start);
            const double angle = azimuthMap.transform(point.azimuth());
            const double distance = radialMap.transform(point.radius());
            painter->setPen(Qt::NoPen);
            painter->setBrush(pen().color());
            painter->drawEllipse(
                pole + QPointF(distance * std::cos(angle), -distance * std::sin(angle)), 3.0, 3.0);
        }
        start = end + 1;
    }
}

QwtText AngleLabels::label(double value) const {
    const double turned = std::fmod(value, 360.0);
    return QwtText(QString::number(turned) + QStringLiteral("°"));
}

PolarNotes::PolarNotes(const PlotStyle& style, QString direction, bool clockwise, QString radius)
    : style_(style),
      direction_(std::move(direction)),
      radius_(std::move(radius)),
      clockwise_(clockwise) {
    setZ(5.0);
}

void PolarNotes::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& radialMap,
                      const QPointF& pole, double, const QRectF& canvasRect) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);

    // Where the radius begins below zero the circle of zero is what an eye looks for.
    if (radialMap.s1() < 0.0 && radialMap.s2() > 0.0) {
        const double zero = radialMap.transform(0.0);
        painter->setPen(QPen(style_.faintText, 1.4));
        painter->setBrush(Qt::NoBrush);
        painter->drawEllipse(pole, zero, zero);
    }

    painter->setFont(plotFont(0.95));
    const QFontMetricsF metrics(painter->font());
    const double arrow = metrics.height() * 0.9;
    const double indent = arrow * 1.6;
    const double radiusWidth = metrics.horizontalAdvance(radius_);
    const double directionWidth = indent + metrics.horizontalAdvance(direction_);
    const double baseline = canvasRect.bottom() - metrics.descent() - 2.0;
    painter->setPen(style_.text);
    painter->drawText(QPointF(canvasRect.right() - radiusWidth - 2.0, baseline), radius_);

    // One above the other where the canvas is too narrow for both.
    const bool narrow = directionWidth + radiusWidth + 2.0 * arrow > canvasRect.width();
    const double upper = narrow ? baseline - metrics.lineSpacing() : baseline;
    painter->drawText(QPointF(canvasRect.left() + indent, upper), direction_);
    drawTurnArrow(*painter, {canvasRect.left() + arrow * 0.7, upper - metrics.ascent() * 0.35},
                  arrow * 0.5);
    painter->restore();
}

int PolarNotes::marginHint() const {
    return static_cast<int>(3.6 * QFontMetricsF(plotFont(0.95)).height());
}

QwtInterval PolarNotes::boundingInterval(int) const {
    constexpr double below = std::numeric_limits<double>::lowest();
    return QwtInterval(below, below);
}

void PolarNotes::drawTurnArrow(QPainter& painter, const QPointF& centre, double size) const {
    // Three quarters of a circle from the left over the top, or its mirror image.
    painter.save();
    painter.translate(centre);
    if (!clockwise_)
        painter.scale(-1.0, 1.0);
    painter.setPen(QPen(style_.text, 1.6, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(QRectF(-size, -size, 2.0 * size, 2.0 * size), 180 * 16, -240 * 16);
    const double end = -60.0 * std::numbers::pi / 180.0;
    const QPointF tip(size * std::cos(end), -size * std::sin(end));
    painter.translate(tip);
    painter.rotate(150.0);
    painter.setBrush(style_.text);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(
        QPolygonF({{size * 0.55, 0.0}, {-size * 0.25, -size * 0.4}, {-size * 0.25, size * 0.4}}));
    painter.restore();
}

} // namespace smat::gui
