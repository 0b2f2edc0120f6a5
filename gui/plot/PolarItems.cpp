#include "gui/plot/PolarItems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <QPainter>
#include <QwtScaleMap>
#include <QwtText>

#include "gui/plot/CurveDrawing.h"
#include "gui/plot/PlotLook.h"

namespace smat::gui {

GappedPolarCurve::GappedPolarCurve(const QString& title, std::vector<PolarSample> samples,
                                   Band band)
    : CurveItemOf(title), samples_(std::move(samples)), band_(band) {
    setStyle(QwtPolarCurve::Lines);
    setLegendAttribute(QwtPolarCurve::LegendShowLine, true);
    setLegendIconSize(QSize(22, 12));
    setRenderHint(QwtPolarItem::RenderAntialiased);
    setItemAttribute(QwtPolarItem::Legend);

    // What Qwt needs to know is how far out the curve reaches.
    QVector<QwtPointPolar> points;
    for (const auto& sample : samples_)
        if (std::isfinite(sample.radius))
            points.push_back({sample.angle_deg, std::max(sample.radius, sample.high)});
    setData(new QwtArraySeriesData<QwtPointPolar>(points));
}

void GappedPolarCurve::draw(QPainter* painter, const QwtScaleMap& azimuthMap,
                            const QwtScaleMap& radialMap, const QPointF& pole, double,
                            const QRectF& canvasRect) const {
    const double column = finestColumn(*painter);
    const double margin = column > 0.0 ? 4.0 : 0.0;
    const QRectF area = canvasRect.adjusted(-margin, -margin, margin, margin);

    double farthest = 1.0;
    for (const QPointF& corner :
         {area.topLeft(), area.topRight(), area.bottomLeft(), area.bottomRight()})
        farthest = std::max(farthest, std::hypot(corner.x() - pole.x(), corner.y() - pole.y()));

    const auto drawable = [&](int i) {
        return std::isfinite(samples_[static_cast<std::size_t>(i)].radius);
    };
    painter->save();
    QColor fill = pen().color();
    fill.setAlphaF(band_ == Band::layer ? layerOpacity : 0.22F);
    for (const SampleRun& run : runsOf(static_cast<int>(samples_.size()), drawable)) {
        const bool withBand = band_ == Band::layer || (band_ == Band::error && isBandVisible());
        const auto [nearest, reach] = radiiOf(run, radialMap, withBand);
        if (nearest > farthest)
            continue; // beyond the corners
        // Points are chosen where lines are unrolled, along a circle and along the radius. On the
        // circle that a run reaches, or the canvas does, a column is one and a half pixels wide.
        const double outer = std::clamp(reach, 1.0, farthest) / (column > 0.0 ? 1.5 : 1.0);
        const auto unrolled = [&](double PolarSample::*value) {
            QPolygonF line(run.last - run.first + 1);
            std::transform(samples_.begin() + run.first, samples_.begin() + run.last + 1,
                           line.begin(), [&](const PolarSample& sample) {
                               return QPointF(azimuthMap.transform(sample.angle_deg) * outer,
                                              std::max(0.0, radialMap.transform(sample.*value)));
                           });
            return line;
        };
        const auto rolled = [&](const QPolygonF& line, const std::vector<qsizetype>& points) {
            const std::vector<QPointF>& directions = directionsFor(azimuthMap);
            QPolygonF result(static_cast<qsizetype>(points.size()));
            std::transform(points.begin(), points.end(), result.begin(), [&](qsizetype point) {
                return pole +
                       directions[static_cast<std::size_t>(run.first + point)] * line[point].y();
            });
            return result;
        };
        const QPolygonF line = unrolled(&PolarSample::radius);
        if (run.first == run.last) {
            if (withBand) {
                painter->setPen(QPen(fill, 3.0));
                drawLine(*painter,
                         rolled(unrolled(&PolarSample::low), {0}) +
                             rolled(unrolled(&PolarSample::high), {0}),
                         area);
            }
            painter->setPen(Qt::NoPen);
            painter->setBrush(pen().color());
            painter->drawEllipse(rolled(line, {0}).front(), 3.0, 3.0);
            continue;
        }
        if (withBand) {
            const QPolygonF low = unrolled(&PolarSample::low);
            const QPolygonF high = unrolled(&PolarSample::high);
            painter->setPen(Qt::NoPen);
            painter->setBrush(fill);
            drawBand(*painter, rolled(high, pointsOfEdge(high, column, Edge::highest)),
                     rolled(low, pointsOfEdge(low, column, Edge::lowest)), area);
        }
        painter->setPen(pen());
        painter->setBrush(Qt::NoBrush);
        drawLine(*painter, rolled(line, pointsOf(line, column)), area);
    }
    QPolygonF hollow;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        if (samples_[i].isHollow && drawable(static_cast<int>(i)))
            hollow << pole + directionsFor(azimuthMap)[i] *
                                 std::max(0.0, radialMap.transform(samples_[i].radius));
    painter->setPen(pen());
    drawHollowPoints(*painter, hollow, hollowFill(), area);
    painter->restore();
}

std::pair<double, double>
GappedPolarCurve::radiiOf(const SampleRun& run, const QwtScaleMap& radialMap, bool withBand) const {
    double nearest = std::numeric_limits<double>::max(),
           reach = std::numeric_limits<double>::lowest(), step_deg = 0.0;
    for (int i = run.first; i <= run.last; ++i) {
        const PolarSample& sample = samples_[static_cast<std::size_t>(i)];
        nearest = std::min(nearest, withBand ? sample.low : sample.radius);
        reach = std::max(reach, sample.radius);
        if (i > run.first)
            step_deg = std::max(step_deg, std::abs(sample.angle_deg - (&sample)[-1].angle_deg));
    }
    // Between two samples the line comes nearer.
    const double nearer = std::cos(std::min(0.5 * step_deg, 90.0) * std::numbers::pi / 180.0);
    return {std::max(radialMap.transform(nearest), 0.0) * nearer, radialMap.transform(reach)};
}

const std::vector<QPointF>& GappedPolarCurve::directionsFor(const QwtScaleMap& azimuthMap) const {
    const std::array<double, 4> turn{azimuthMap.s1(), azimuthMap.s2(), azimuthMap.p1(),
                                     azimuthMap.p2()};
    if (directions_.size() != samples_.size() || turn != turn_) {
        turn_ = turn;
        directions_.clear();
        for (const PolarSample& sample : samples_) {
            const double angle = azimuthMap.transform(sample.angle_deg);
            directions_.emplace_back(std::cos(angle), -std::sin(angle));
        }
    }
    return directions_;
}

void RadiusLabels::draw(QPainter* painter, const QPalette& palette) const {
    constexpr double gap_px = 4.0;
    QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
    std::ranges::sort(ticks);
    double closest_px = std::numeric_limits<double>::max(), widest_px = 0.0;
    for (qsizetype i = 0; i < ticks.size(); ++i) {
        widest_px = std::max(widest_px, labelRect(painter->font(), ticks[i]).width());
        if (i > 0)
            closest_px = std::min(closest_px, std::abs(scaleMap().transform(ticks[i]) -
                                                       scaleMap().transform(ticks[i - 1])));
    }
    const auto every = static_cast<qsizetype>(
        std::max(1.0, std::ceil((widest_px + gap_px) / std::max(closest_px, 1.0))));
    numbered_.clear();
    for (qsizetype i = ticks.size() - 1; i >= 0; i -= every)
        numbered_ << ticks[i];
    NumberLabels::draw(painter, palette);
}

void RadiusLabels::drawLabel(QPainter* painter, double value) const {
    if (numbered_.contains(value))
        NumberLabels::drawLabel(painter, value);
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
