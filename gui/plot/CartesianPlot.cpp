#include "gui/plot/CartesianPlot.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QPainter>
#include <QwtLegend>
#include <QwtPlotCanvas>
#include <QwtPlotGrid>
#include <QwtPlotLayout>
#include <QwtPlotMarker>
#include <QwtScaleMap>
#include <QwtScaleWidget>
#include <QwtText>

#include "gui/plot/CartesianItems.h"
#include "gui/plot/CurveDrawing.h"
#include "gui/plot/PlotLook.h"
#include "gui/plot/PlotNavigator.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

Interval padded(Interval range, bool logarithmic, double part) {
    if (logarithmic) {
        const double ratio = std::max(range.maximum / range.minimum, 1.001);
        const double factor = std::pow(ratio, part);
        return {range.minimum / factor, range.maximum * factor};
    }
    double span = range.maximum - range.minimum;
    if (span <= 0.0)
        span = std::max(std::abs(range.maximum), 1.0) * 0.2;
    const double pad = part > 0.0 ? span * part : (range.maximum > range.minimum ? 0.0 : span);
    return {range.minimum - pad, range.maximum + pad};
}

/// The part of a logarithmic axis that has something to say: no lower than a tenth of the least
/// value, however close to 0 its error comes, nor than what rounding leaves of 0.
std::optional<Interval> logarithmicRange(const std::vector<Curve>& curves) {
    constexpr double leastOfError = 0.1, leastOfLargest = 1e-9;
    const auto values = rangeOf(curves, &Curve::y, true);
    auto range = rangeWithErrors(curves, true);
    if (values && range)
        range->minimum = std::max(
            {range->minimum, leastOfError * values->minimum, leastOfLargest * range->maximum});
    return range;
}

/// Whether a sample is drawn as a dot where x begins or ends: one that stands by itself or warns of
/// something.
bool hasDotAt(const Interval& range, const std::vector<Curve>& curves) {
    const auto isDotOf = [&](const Curve& curve) {
        for (std::size_t i = 0; i < curve.warnings.size(); ++i)
            if (!curve.warnings[i].isEmpty() &&
                (curve.x[i] == range.minimum || curve.x[i] == range.maximum))
                return true;
        return std::ranges::any_of(numbersOf(curve), [&](const SampleRun& run) {
            const double x = curve.x[static_cast<std::size_t>(run.first)];
            return run.first == run.last && (x == range.minimum || x == range.maximum);
        });
    };
    return range.minimum < range.maximum && std::ranges::any_of(curves, isDotOf);
}

/// What an axis can show: its ends are finite and can be told apart.
bool isUsable(const Interval& range) {
    return std::isfinite(range.minimum) && std::isfinite(range.maximum) &&
           std::abs(range.maximum) < 1e250 && std::abs(range.minimum) < 1e250 &&
           range.maximum - range.minimum >
               1e-12 * std::max(std::abs(range.minimum), std::abs(range.maximum));
}

} // namespace

CartesianPlot::CartesianPlot(const PlotStyle& style, QWidget* parent)
    : QwtPlot(parent), CurvePlot(style) {
    setObjectName("cartesianPlot");
    setFocusPolicy(Qt::StrongFocus);
    setAutoReplot(false);
    auto* sheet = new QwtPlotCanvas(this);
    sheet->setFrameStyle(QFrame::NoFrame);
    setCanvas(sheet);
    plotLayout()->setAlignCanvasToScales(true);

    grid_ = new QwtPlotGrid;
    grid_->enableXMin(true);
    grid_->enableYMin(true);
    grid_->setZ(0.0);
    grid_->attach(this);

    auto* legend = new QwtLegend;
    insertLegend(legend, QwtPlot::BottomLegend);
    connect(legend, &QwtLegend::clicked, this, [this](const QVariant& item, int) {
        toggle(dynamic_cast<const CurveItem*>(infoToItem(item)));
    });

    navigator_ = std::make_unique<PlotNavigator>(*this);
    connect(navigator_.get(), &PlotNavigator::readoutChanged, this, &CartesianPlot::readoutChanged);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this, [this] {
        const std::vector<bool> shown = shownCurves();
        present(inShownUnits(stored_));
        showCurves(shown);
    });
    applyLook();
}

CartesianPlot::~CartesianPlot() {
    // Curves refer to the data, which would go before them.
    detachItems(QwtPlotItem::Rtti_PlotCurve, true);
}

void CartesianPlot::applyLook() {
    setCanvasBackground(style_.canvas);
    dressPlot(*this, style_);
    grid_->setMajorPen(style_.grid, 1.0);
    grid_->setMinorPen(style_.minorGrid, 1.0);
    dressLegend(*static_cast<QwtLegend*>(legend()), style_);
    setTitle(plotTitle(data_.title, data_.conditions, style_));
    setAxisTitle(xBottom, axisText(data_.xTitle, style_));
    setAxisTitle(yLeft, axisText(data_.yTitle, style_));
    dressItems();
    dressMarks();
}

void CartesianPlot::addMarks() {
    detachItems(QwtPlotItem::Rtti_PlotMarker, true);
    marks_.clear();
    for (const PlotMark& mark : data_.marks) {
        auto* line = new QwtPlotMarker;
        line->setLineStyle(QwtPlotMarker::VLine);
        line->setXValue(mark.x);
        line->setLabelOrientation(Qt::Vertical);
        line->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
        line->setSpacing(4);
        line->setZ(5.0); // above the grid, below the curves
        line->attach(this);
        marks_.push_back(line);
    }
    dressMarks();
}

void CartesianPlot::dressMarks() {
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        marks_[i]->setLinePen(style_.text, 1.0, Qt::DashLine);
        QwtText label = axisText(data_.marks[i].label, style_);
        label.setRenderFlags(Qt::AlignLeft);
        marks_[i]->setLabel(label);
    }
}

void CartesianPlot::setLook(const PlotStyle& style) {
    style_ = style;
    applyLook();
    replot();
}

QWidget* CartesianPlot::sheet() const {
    return const_cast<QWidget*>(canvas());
}

void CartesianPlot::setData(PlotData data) {
    for (const auto& curve : data.curves)
        curve.check();
    stored_ = std::move(data);
    present(inShownUnits(stored_));
}

void CartesianPlot::present(PlotData data) {
    detachItems(QwtPlotItem::Rtti_PlotCurve, true);
    forgetItems();
    data_ = std::move(data);
    drawn_.clear();
    for (const Curve& curve : data_.curves)
        drawn_.push_back(curve.drawn());

    setTitle(plotTitle(data_.title, data_.conditions, style_));
    setAxisTitle(xBottom, axisText(data_.xTitle, style_));
    setAxisTitle(yLeft, axisText(data_.yTitle, style_));
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        auto* item = new SampledCurve(drawn_[i]);
        item->setZ(10.0 + static_cast<double>(i));
        // What a lone curve is may stand at its axis.
        item->setItemAttribute(QwtPlotItem::Legend, data_.curves[i].name != data_.xTitle);
        item->attach(this);
        adopt(item);
    }
    addMarks();
    if (legend() != nullptr)
        legend()->setVisible(!data_.curves.empty());
    applyAxes();
    setView(fullView());
    history_.clear();
    emit viewChanged();
}

void CartesianPlot::applyAxes() {
    const auto engine = [](bool logarithmic) -> QwtScaleEngine* {
        if (logarithmic)
            return new ReadableLogScale;
        return new QwtLinearScaleEngine;
    };
    setAxisScaleEngine(xBottom, engine(data_.xLogarithmic));
    setAxisScaleEngine(yLeft, engine(data_.yLogarithmic));
    setAxisMaxMinor(xBottom, data_.xLogarithmic ? 9 : 5);
    setAxisMaxMinor(yLeft, data_.yLogarithmic ? 9 : 5);
}

void CartesianPlot::setLogarithmic(QwtPlot::Axis axis, bool on) {
    for (PlotData* data : {&stored_, &data_})
        (axis == xBottom ? data->xLogarithmic : data->yLogarithmic) = on;
    applyAxes();
    history_.clear();
    setView(fullView());
}

bool CartesianPlot::isLogarithmic(QwtPlot::Axis axis) const {
    return axis == xBottom ? data_.xLogarithmic : data_.yLogarithmic;
}

CartesianPlot::View CartesianPlot::fullView() const {
    const bool xLog = data_.xLogarithmic;
    const bool yLog = data_.yLogarithmic;
    View view{{xLog ? 1.0 : 0.0, xLog ? 10.0 : 1.0}, {yLog ? 1.0 : 0.0, yLog ? 10.0 : 1.0}};
    if (const auto range = rangeOf(data_.curves, &Curve::x, xLog))
        view.x = padded(*range, xLog, hasDotAt(*range, data_.curves) ? 0.02 : 0.0);
    if (const auto range = yLog ? logarithmicRange(drawn_) : rangeWithErrors(drawn_, false))
        view.y = padded(*range, yLog, 0.06);
    return view;
}

CartesianPlot::View CartesianPlot::view() const {
    const QwtInterval x = axisInterval(xBottom);
    const QwtInterval y = axisInterval(yLeft);
    return {{x.minValue(), x.maxValue()}, {y.minValue(), y.maxValue()}};
}

void CartesianPlot::setView(const View& view) {
    setAxisScale(xBottom, view.x.minimum, view.x.maximum);
    setAxisScale(yLeft, view.y.minimum, view.y.maximum);
    replot();
    emit viewChanged();
}

void CartesianPlot::resetView() {
    rememberView();
    setView(fullView());
}

void CartesianPlot::rememberView() {
    history_.remember(view());
}

void CartesianPlot::undoZoom() {
    if (const auto last = history_.takeBack())
        setView(*last);
}

QRectF CartesianPlot::seenRect() const {
    const View seen = view();
    return {QPointF(transform(xBottom, seen.x.minimum), transform(yLeft, seen.y.maximum)),
            QPointF(transform(xBottom, seen.x.maximum), transform(yLeft, seen.y.minimum))};
}

void CartesianPlot::zoomAt(const QPointF& point, double factor) {
    const QRectF area = seenRect();
    zoomTo(
        {point + (area.topLeft() - point) * factor, point + (area.bottomRight() - point) * factor});
}

void CartesianPlot::panBy(const QPointF& offset) {
    zoomTo(seenRect().translated(-offset));
}

void CartesianPlot::zoomTo(const QRectF& canvasRect) {
    const View wanted{
        {invTransform(xBottom, canvasRect.left()), invTransform(xBottom, canvasRect.right())},
        {invTransform(yLeft, canvasRect.bottom()), invTransform(yLeft, canvasRect.top())}};
    if (isUsable(wanted.x) && isUsable(wanted.y))
        setView(wanted);
}

QString CartesianPlot::readoutAt(const QPointF& canvasPoint) const {
    if (!QRectF(canvas()->rect()).contains(canvasPoint))
        return {};
    const double x = invTransform(xBottom, canvasPoint.x());
    return data_.xTitle + ": " + formattedNumber(x) + readoutsAt(x, 0.0);
}

CartesianPlot* CartesianPlot::makePrintCopy() const {
    auto* twin = new CartesianPlot(PlotStyle::paper());
    twin->setData(stored_);
    twin->setView(view());
    twin->showAsIn(*this);
    return twin;
}

void CartesianPlot::drawCanvas(QPainter* painter) {
    drawOnPicture(*painter, canvas()->size(), style_.canvas,
                  [this](QPainter& inside) { QwtPlot::drawCanvas(&inside); });
}

void CartesianPlot::keyPressEvent(QKeyEvent* event) {
    if (!navigator_->handleKey(*event))
        QwtPlot::keyPressEvent(event);
}

void CartesianPlot::paintCrosshair(QPainter& painter, const QPointF& point) const {
    const QRectF area = canvas()->rect();
    painter.setPen(QPen(style_.crosshair, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(point.x(), 0.0), QPointF(point.x(), area.bottom()));
    painter.drawLine(QPointF(0.0, point.y()), QPointF(area.right(), point.y()));

    const double x = invTransform(xBottom, point.x());
    paintReadouts(painter, point, data_.xTitle + "  " + formattedNumber(x), x, 0.0,
                  [&](double value) -> std::optional<QPointF> {
                      if (data_.yLogarithmic && !(value > 0.0))
                          return std::nullopt;
                      return QPointF(point.x(), transform(yLeft, value));
                  });
}

} // namespace smat::gui

#include "moc_CartesianPlot.cpp"
