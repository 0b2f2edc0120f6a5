#include "gui/plot/CartesianItems.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QwtScaleMap>

namespace smat::gui {

namespace {

constexpr double dotRadius_px = 3.0;

/// Whether every sample of a curve stands alone.
bool isDots(const Curve& curve) {
    const std::vector<SampleRun> runs = numbersOf(curve);
    return !runs.empty() &&
           std::ranges::all_of(runs, [](const SampleRun& run) { return run.first == run.last; });
}

} // namespace

std::vector<SampleRun> numbersOf(const Curve& curve) {
    return runsOf(static_cast<int>(curve.x.size()), [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        return std::isfinite(curve.x[at]) && std::isfinite(curve.y[at]);
    });
}

QwtGraphic SampledCurve::legendIcon(int index, const QSizeF& size) const {
    if (!isDots(curve_))
        return QwtPlotCurve::legendIcon(index, size);
    QwtGraphic icon;
    icon.setDefaultSize(size);
    QPainter painter(&icon);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen().color());
    painter.drawEllipse(QRectF(QPointF(), size).center(), dotRadius_px, dotRadius_px);
    return icon;
}

SampledCurve::SampledCurve(const Curve& curve) : CurveItemOf(curve.name), curve_(curve) {
    setRenderHint(QwtPlotItem::RenderAntialiased);
    setLegendAttribute(QwtPlotCurve::LegendShowLine);
    setLegendIconSize(QSize(22, 12));
    setRawSamples(curve.x.data(), curve.y.data(), static_cast<int>(curve.x.size()));
}

void SampledCurve::drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                              const QRectF& canvasRect, int, int) const {
    const bool xPositive = xMap.transformation() != nullptr;
    const bool yPositive = yMap.transformation() != nullptr;
    const auto drawable = [&](int i) {
        const double x = curve_.x[static_cast<std::size_t>(i)];
        const double y = curve_.y[static_cast<std::size_t>(i)];
        return std::isfinite(x) && std::isfinite(y) && (!xPositive || x > 0.0) &&
               (!yPositive || y > 0.0);
    };
    const double column = finestColumn(*painter);
    // On a screen lines go on below the frame, whose clipping hides how they end.
    const double margin = column > 0.0 ? 4.0 : 0.0;
    const QRectF area = canvasRect.adjusted(-margin, -margin, margin, margin);
    const double xLow = std::min(xMap.s1(), xMap.s2());
    const double xHigh = std::max(xMap.s1(), xMap.s2());

    painter->save();
    for (const SampleRun& run : runsOf(static_cast<int>(curve_.x.size()), drawable)) {
        const SampleRun seen = visiblePart(curve_.x, run, xLow, xHigh);
        if (curve_.isLayer() || (isBandVisible() && !curve_.error.empty()))
            drawBand(*painter, xMap, yMap, area, seen.first, seen.last, column);
        QPolygonF line(seen.last - seen.first + 1);
        std::transform(curve_.x.begin() + seen.first, curve_.x.begin() + seen.last + 1,
                       curve_.y.begin() + seen.first, line.begin(), [&](double x, double y) {
                           return QPointF(xMap.transform(x), yMap.transform(y));
                       });
        if (run.first == run.last) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(pen().color());
            if (area.contains(line.front()))
                painter->drawEllipse(line.front(), dotRadius_px, dotRadius_px);
            continue;
        }
        painter->setPen(pen());
        painter->setBrush(Qt::NoBrush);
        drawLine(*painter, chosen(line, pointsOf(line, column)), area);
    }
    QPolygonF hollow;
    for (std::size_t i = 0; i < curve_.warnings.size(); ++i)
        if (!curve_.warnings[i].isEmpty() && drawable(static_cast<int>(i)))
            hollow << QPointF(xMap.transform(curve_.x[i]), yMap.transform(curve_.y[i]));
    painter->setPen(pen());
    drawHollowPoints(*painter, hollow, hollowFill(), area);
    painter->restore();
}

void SampledCurve::drawBand(QPainter& painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                            const QRectF& area, int from, int to, double column) const {
    // Where the lower end has no logarithm the band reaches the bottom of the plot.
    const bool logarithmic = yMap.transformation() != nullptr;
    const double bottom = std::min(yMap.s1(), yMap.s2());
    const std::vector<double>& widths = curve_.isLayer() ? curve_.base : curve_.error;
    const auto hasError = [&](int i) {
        return std::isfinite(widths[static_cast<std::size_t>(from + i)]);
    };
    /// Lower and upper end of the band at a sample.
    const auto endsAt = [&](std::size_t i) -> std::pair<double, double> {
        if (curve_.isLayer())
            return std::minmax(curve_.base[i], curve_.y[i]);
        return {curve_.y[i] - curve_.error[i], curve_.y[i] + curve_.error[i]};
    };
    QColor fill = pen().color();
    fill.setAlphaF(curve_.isLayer() ? layerOpacity : 0.22F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const SampleRun& run : runsOf(to - from + 1, hasError)) {
        if (run.first == run.last) {
            // A band without width is a bar.
            const auto i = static_cast<std::size_t>(from + run.first);
            const double x = xMap.transform(curve_.x[i]);
            const auto [low, high] = endsAt(i);
            painter.setPen(QPen(fill, 3.0));
            for (const QPolygonF& bar :
                 clipped(QPolygonF{{x, yMap.transform(high)},
                                   {x, yMap.transform(logarithmic && low <= 0.0 ? bottom : low)}},
                         area))
                painter.drawPolyline(bar);
            painter.setPen(Qt::NoPen);
            continue;
        }
        QPolygonF upper(run.last - run.first + 1), lower(upper.size());
        QPointF *above = upper.data(), *below = lower.data();
        for (int k = run.first; k <= run.last; ++k) {
            const auto i = static_cast<std::size_t>(from + k);
            const double x = xMap.transform(curve_.x[i]);
            const auto [low, high] = endsAt(i);
            *above++ = QPointF(x, yMap.transform(high));
            *below++ = QPointF(x, yMap.transform(logarithmic && low <= 0.0 ? bottom : low));
        }
        // The y of the canvas grows downwards.
        smat::gui::drawBand(painter, chosen(upper, pointsOfEdge(upper, column, Edge::lowest)),
                            chosen(lower, pointsOfEdge(lower, column, Edge::highest)), area);
    }
}

} // namespace smat::gui
