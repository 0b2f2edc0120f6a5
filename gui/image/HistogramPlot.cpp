#include "gui/image/HistogramPlot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QApplication>
#include <QEvent>
#include <QFontMetricsF>
#include <QPen>
#include <QwtPlotCanvas>
#include <QwtPlotHistogram>
#include <QwtPlotLayout>
#include <QwtPlotMarker>
#include <QwtScaleDraw>
#include <QwtScaleEngine>
#include <QwtScaleMap>

#include "gui/plot/PlotLook.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

HistogramPlot::HistogramPlot(QWidget* parent) : QwtPlot(parent) {
    setObjectName("histogram");
    bars_ = new QwtPlotHistogram;
    bars_->setStyle(QwtPlotHistogram::Columns);
    bars_->attach(this);
    for (QwtPlotMarker** marker : {&low_, &high_}) {
        *marker = new QwtPlotMarker;
        (*marker)->setLineStyle(QwtPlotMarker::VLine);
        (*marker)->attach(this);
    }
    plotLayout()->setAlignCanvasToScales(true);
    dress();
    draw();
}

HistogramPlot::~HistogramPlot() = default;

void HistogramPlot::setHistogram(const irsg::Histogram& histogram, const QString& title) {
    histogram_ = histogram;
    title_ = title;
    draw();
}

void HistogramPlot::setLogarithmicCounts(bool on) {
    logarithmicCounts_ = on;
    draw();
}

void HistogramPlot::setLimits(const irsg::DisplayLimits& limits) {
    low_->setXValue(limits.low);
    high_->setXValue(limits.high);
    replot();
}

void HistogramPlot::draw() {
    // On a logarithmic axis a bar begins below one pixel, so that single pixels are seen.
    const double base = logarithmicCounts_ ? 0.5 : 0.0;
    QVector<QwtIntervalSample> samples;
    double most = 1.0;
    for (std::size_t i = 0; i < histogram_.counts.size(); ++i) {
        if (histogram_.counts[i] == 0)
            continue;
        const auto count = static_cast<double>(histogram_.counts[i]);
        most = std::max(most, count);
        samples << QwtIntervalSample(count, histogram_.edges[i], histogram_.edges[i + 1]);
    }
    bars_->setBaseline(base);
    bars_->setSamples(samples);

    if (logarithmicCounts_)
        setAxisScaleEngine(yLeft, new QwtLogScaleEngine);
    else
        setAxisScaleEngine(yLeft, new QwtLinearScaleEngine);
    setAxisScale(yLeft, base, logarithmicCounts_ ? most * 2.0 : most * 1.05);
    if (histogram_.logarithmic)
        setAxisScaleEngine(xBottom, new ReadableLogScale);
    else
        setAxisScaleEngine(xBottom, new QwtLinearScaleEngine);
    setAxisMaxMajor(yLeft, 4);
    const auto style = PlotStyle::screen(QApplication::palette());
    setAxisTitle(xBottom, axisText(title_, style));
    setAxisTitle(yLeft, axisText(tr("pixels"), style));
    fitTicks();
    replot();
}

void HistogramPlot::fitTicks() {
    if (histogram_.edges.empty())
        return;
    constexpr int mostMajor = 6, mostMinor = 5;
    const double low = histogram_.edges.front(), high = histogram_.edges.back();
    const QwtScaleEngine* engine = axisScaleEngine(xBottom);
    QwtScaleDiv division = engine->divideScale(low, high, mostMajor, mostMinor);
    const QFont font = axisFont(xBottom);
    const double gap_px = QFontMetricsF(font).averageCharWidth();
    QwtScaleMap map;
    map.setTransformation(engine->transformation());
    map.setScaleInterval(low, high);
    map.setPaintInterval(0.0, std::max(canvas()->contentsRect().width(), 1));
    const auto overlap = [&](const QList<double>& ticks) {
        double end_px = -std::numeric_limits<double>::infinity();
        return std::ranges::any_of(ticks, [&](double tick) {
            const double half_px = 0.5 * axisScaleDraw(xBottom)->label(tick).textSize(font).width();
            const double at_px = map.transform(tick);
            const bool isOver = at_px - half_px < end_px + gap_px;
            end_px = at_px + half_px;
            return isOver;
        });
    };
    const auto isDecade = [](double tick) {
        const double exponent = std::log10(std::abs(tick));
        return std::abs(exponent - std::round(exponent)) < 1e-9;
    };
    QList<double> major = division.ticks(QwtScaleDiv::MajorTick);
    QList<double> minor = division.ticks(QwtScaleDiv::MinorTick);
    while (major.size() > 1 && overlap(major)) {
        // Decades first; of equals every second one.
        const bool mixed = histogram_.logarithmic && std::ranges::count_if(major, isDecade) > 1 &&
                           !std::ranges::all_of(major, isDecade);
        QList<double> fewer;
        for (qsizetype i = 0; i < major.size(); ++i)
            (mixed ? isDecade(major[i]) : i % 2 == 0) ? fewer << major[i] : minor << major[i];
        major = fewer;
    }
    division.setTicks(QwtScaleDiv::MajorTick, major);
    division.setTicks(QwtScaleDiv::MinorTick, minor);
    setAxisScaleDiv(xBottom, division);
}

void HistogramPlot::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    fitTicks();
    replot();
}

void HistogramPlot::dress() {
    palette_.taken();
    const auto style = PlotStyle::screen(QApplication::palette());
    dressPlot(*this, style);
    setCanvasBackground(style.canvas);
    if (auto* frame = qobject_cast<QFrame*>(canvas()))
        frame->setFrameStyle(QFrame::NoFrame);
    setContentsMargins(4, 4, 8, 2);
    setMinimumSize(0, 0);
    QColor fill = style.curve(0);
    bars_->setPen(QPen(Qt::NoPen));
    bars_->setBrush(fill);
    for (QwtPlotMarker* marker : {low_, high_})
        marker->setLinePen(QPen(style.crosshair, 1.0, Qt::DashLine));
}

void HistogramPlot::changeEvent(QEvent* event) {
    QwtPlot::changeEvent(event);
    palette_.follow(*this, *event, [this] {
        dress();
        draw();
    });
}

} // namespace smat::gui

#include "moc_HistogramPlot.cpp"
