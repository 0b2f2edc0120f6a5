#include "gui/plot/PolarPlot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <QKeyEvent>
#include <QPainter>
#include <QwtLegend>
#include <QwtPointPolar>
#include <QwtPolarCanvas>
#include <QwtPolarGrid>
#include <QwtScaleDraw>
#include <QwtScaleEngine>
#include <QwtScaleMap>

#include "gui/plot/CurveDrawing.h"
#include "gui/plot/PlotLook.h"
#include "gui/plot/PlotNavigator.h"
#include "gui/plot/PolarItems.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

constexpr double turn_deg = 360.0;
constexpr double centre_dB = -40.0;

/// Some five circles in what is seen, whatever the zoom: more would run into each other's numbers.
class FewCircles : public QwtLinearScaleEngine {
  public:
    QwtScaleDiv divideScale(double x1, double x2, int, int, double) const override {
        return QwtLinearScaleEngine::divideScale(x1, x2, 5, 2, 0.0);
    }
};

} // namespace

PolarPlot::PolarPlot(const PlotStyle& style, QWidget* parent)
    : QwtPolarPlot(parent), CurvePlot(style) {
    setObjectName("polarPlot");
    setFocusPolicy(Qt::StrongFocus);
    setAutoReplot(false);
    setAzimuthOrigin(std::numbers::pi / 2.0);
    setContentsMargins(12, 10, 12, 10);
    setMinimumSize(320, 320);

    canvas()->setFrameStyle(QFrame::NoFrame);
    setScaleEngine(QwtPolar::Radius, new FewCircles);
    grid_ = new QwtPolarGrid;
    for (int scale = 0; scale < QwtPolar::ScaleCount; ++scale) {
        grid_->showGrid(scale, true);
        grid_->showMinorGrid(scale, scale == QwtPolar::Radius);
    }
    for (int axis = 0; axis < QwtPolar::AxesCount; ++axis)
        grid_->showAxis(axis, axis == QwtPolar::AxisAzimuth || axis == QwtPolar::AxisRight);
    grid_->setFont(plotFont(0.9));
    grid_->setAzimuthScaleDraw(new AngleLabels);
    // Numbers end at their circle, so that the last one does not run into 90°.
    auto* radii = new RadiusLabels;
    radii->setLabelAlignment(Qt::AlignLeft | Qt::AlignBottom);
    grid_->setScaleDraw(QwtPolar::AxisRight, radii);
    grid_->setDisplayFlag(QwtPolarGrid::HideMaxRadiusLabel, false);
    grid_->setDisplayFlag(QwtPolarGrid::SmartOriginLabel, true);
    grid_->attach(this);

    auto* legend = new QwtLegend;
    insertLegend(legend, QwtPolarPlot::BottomLegend);
    connect(legend, &QwtLegend::clicked, this, [this](const QVariant& item, int) {
        toggle(dynamic_cast<const CurveItem*>(infoToItem(item)));
    });
    navigator_ = std::make_unique<PlotNavigator>(*this);
    connect(navigator_.get(), &PlotNavigator::readoutChanged, this, &PolarPlot::readoutChanged);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            [this] { present(inShownUnits(stored_)); });
    applyLook();
}

PolarPlot::~PolarPlot() = default;

void PolarPlot::applyLook() {
    setPlotBackground(style_.canvas);
    QPalette colours = palette();
    colours.setColor(QPalette::Window, style_.background);
    colours.setColor(QPalette::WindowText, style_.text);
    colours.setColor(QPalette::Text, style_.text);
    setPalette(colours);
    setAutoFillBackground(true);
    canvas()->setPalette(colours);
    grid_->setPen(QPen(style_.text));
    grid_->setMajorGridPen(QPen(style_.grid, 1.0));
    grid_->setMinorGridPen(QPen(style_.minorGrid, 1.0));
    grid_->setAxisPen(QwtPolar::AxisAzimuth, QPen(style_.text));
    grid_->setAxisPen(QwtPolar::AxisRight, QPen(style_.faintText));
    dressLegend(*static_cast<QwtLegend*>(legend()), style_);
}

void PolarPlot::setLook(const PlotStyle& style) {
    style_ = style;
    applyLook();
    setTitle(plotTitle(data_.title, data_.conditions, style_));
    const View seen{zoomFactor(), zoomPos(), limits_};
    rebuild();
    if (seen.factor < 1.0)
        zoom(seen.middle, seen.factor);
    replot();
}

QWidget* PolarPlot::sheet() const {
    return const_cast<QwtPolarCanvas*>(canvas());
}

void PolarPlot::setData(PolarData data) {
    for (const auto& curve : data.curves)
        curve.check();
    stored_ = std::move(data);
    present(inShownUnits(stored_));
}

void PolarPlot::present(PolarData data) {
    data_ = std::move(data);
    if (!canBeDecibel() && radiusScale_ == RadiusScale::decibel) {
        radiusScale_ = RadiusScale::linear;
        limits_.reset();
    }
    drawn_.clear();
    for (const Curve& curve : data_.curves)
        drawn_.push_back(curve.drawn(turn_deg));
    setTitle(plotTitle(data_.title, data_.conditions, style_));
    // A scale that runs backwards turns clockwise.
    setScale(QwtPolar::Azimuth, data_.clockwise ? turn_deg : 0.0, data_.clockwise ? 0.0 : turn_deg,
             data_.clockwise ? -30.0 : 30.0);
    history_.clear();
    rebuild();
}

void PolarPlot::setRadiusScale(RadiusScale scale) {
    if (radiusScale_ == scale || (scale == RadiusScale::decibel && !canBeDecibel()))
        return;
    radiusScale_ = scale;
    limits_.reset();
    history_.clear();
    rebuild();
}

void PolarPlot::setRadiusLimits(const std::optional<Interval>& limits) {
    limits_ = limits;
    rebuild();
}

Interval PolarPlot::radiusLimits() const {
    const QwtInterval interval = scaleDiv(QwtPolar::Radius)->interval();
    return {interval.minValue(), interval.maxValue()};
}

double PolarPlot::radiusOf(double value) const {
    if (radiusScale_ == RadiusScale::linear)
        return value;
    if (!(value > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    return 10.0 * std::log10(value / largest_);
}

void PolarPlot::rebuild() {
    const std::vector<bool> visible = shownCurves();
    detachItems(QwtPolarItem::Rtti_PolarCurve, true);
    forgetItems();

    setRadiusAxis();
    for (std::size_t i = 0; i < data_.curves.size(); ++i)
        addCurve(i);
    QString radius =
        data_.radiusTitle.isEmpty() ? QString() : tr("radius: %1").arg(data_.radiusTitle);
    if (radiusScale_ == RadiusScale::decibel)
        radius += tr(", dB below %1").arg(formattedNumber(largest_));
    if (const int left = samplesLeftOut(); left > 0)
        radius += tr(" (%1 values not above 0 left out)").arg(left);
    notes_ = std::make_unique<PolarNotes>(style_, data_.directionNote, data_.clockwise, radius);
    notes_->attach(this);

    showCurves(visible);
    showWhole();
}

void PolarPlot::setRadiusAxis() {
    // The radius ends at a round number above the largest value; it begins at 0, or below where a
    // contrast is negative.
    const bool decibel = radiusScale_ == RadiusScale::decibel;
    const auto range = rangeOf(drawn_, &Curve::y, decibel);
    largest_ = range ? range->maximum : 1.0;
    double low = 0.0, high = 0.0;
    if (decibel) {
        low = centre_dB;
    } else {
        const auto all = rangeWithErrors(drawn_, false);
        // Bands of errors alone do not move the middle below 0.
        const bool isAnyNegative = std::ranges::any_of(drawn_, [](const Curve& curve) {
            return std::ranges::any_of(curve.y, [](double y) { return y < 0.0; });
        });
        low = all && isAnyNegative ? std::min(all->minimum, 0.0) : 0.0;
        high = all ? std::max(all->maximum, 0.0) : 1.0;
        if (!(high > low))
            high = low + 1.0;
        double step = 0.0;
        QwtLinearScaleEngine().autoScale(5, low, high, step);
    }
    setScale(QwtPolar::Radius, limits_ ? limits_->minimum : low, limits_ ? limits_->maximum : high);
}

void PolarPlot::addCurve(std::size_t index) {
    const Curve& curve = drawn_[index];
    std::vector<PolarSample> samples;
    const auto add = [&](double angle_deg, std::size_t k) {
        const double error = curve.error.empty() ? 0.0 : curve.error[k];
        const double y = curve.y[k];
        PolarSample sample{angle_deg, radiusOf(y), radiusOf(y), radiusOf(y),
                           !curve.warningOf(k).isEmpty()};
        if (std::isfinite(error) && std::isfinite(sample.radius)) {
            const auto [least, most] =
                curve.isLayer() ? std::minmax({curve.base[k], y}) : std::pair(y - error, y + error);
            // A lower end without logarithm reaches the middle.
            const double low = radiusOf(least);
            sample.low = std::isfinite(low) ? low : -std::numeric_limits<double>::max();
            sample.high = radiusOf(most);
        }
        if (std::isfinite(angle_deg))
            samples.push_back(sample);
    };
    for (std::size_t k = 0; k < curve.x.size(); ++k)
        add(curve.x[k], k);
    // Then the first sample is drawn again.
    if (data_.curves[index].goesRound(turn_deg))
        add(curve.x.front() + turn_deg, 0);
    using Band = GappedPolarCurve::Band;
    auto* item = new GappedPolarCurve(curve.name, std::move(samples),
                                      curve.isLayer()        ? Band::layer
                                      : !curve.error.empty() ? Band::error
                                                             : Band::none);
    item->setZ(10.0 + static_cast<double>(index));
    item->attach(this);
    adopt(item);
}

int PolarPlot::samplesLeftOut() const {
    if (radiusScale_ == RadiusScale::linear)
        return 0;
    int count = 0;
    for (const auto& curve : data_.curves)
        count += static_cast<int>(
            std::count_if(curve.y.begin(), curve.y.end(), [](double v) { return v <= 0.0; }));
    return count;
}

void PolarPlot::showWhole() {
    unzoom();
    updateLayout(); // a zoomed circle takes the whole width, another one its own
    replot();
    emit viewChanged();
}

void PolarPlot::resetView() {
    rememberView();
    if (limits_)
        setRadiusLimits({});
    else
        showWhole();
}

void PolarPlot::rememberView() {
    history_.remember({zoomFactor(), zoomPos(), limits_});
}

void PolarPlot::undoZoom() {
    const auto last = history_.takeBack();
    if (!last)
        return;
    if (last->limits != limits_)
        setRadiusLimits(last->limits);
    unzoom();
    if (last->factor < 1.0)
        zoom(last->middle, last->factor);
    updateLayout();
    replot();
    emit viewChanged();
}

QPointF PolarPlot::canvasPoint(double angle_deg, double value) const {
    const QwtScaleMap azimuth = scaleMap(QwtPolar::Azimuth);
    const QwtScaleMap radial = scaleMap(QwtPolar::Radius);
    const double angle = azimuth.transform(angle_deg);
    const double distance = std::max(0.0, radial.transform(radiusOf(value)));
    return plotRect().center() + QPointF(distance * std::cos(angle), -distance * std::sin(angle));
}

double PolarPlot::angleAt(const QPointF& point) const {
    const QPointF offset = point - plotRect().center();
    // Degrees from the top, growing the way the plot's angle grows.
    double angle = std::atan2(offset.x(), -offset.y()) * 180.0 / std::numbers::pi;
    if (!data_.clockwise)
        angle = -angle;
    return angle < 0.0 ? angle + turn_deg : angle;
}

QString PolarPlot::readoutAt(const QPointF& point) const {
    const double angle = angleAt(point);
    return QStringLiteral("%1°").arg(angle, 0, 'f', 1) + readoutsAt(angle, turn_deg);
}

PolarPlot* PolarPlot::makePrintCopy() const {
    auto* twin = new PolarPlot(PlotStyle::paper());
    twin->radiusScale_ = radiusScale_;
    twin->limits_ = limits_;
    twin->setData(stored_);
    twin->showAsIn(*this);
    return twin;
}

void PolarPlot::placePole(const QPointF& pole, double factor) {
    // Qwt keeps the point of the plot that lies at the canvas's middle, in polar coordinates.
    unzoom();
    const QRectF whole = plotRect();
    const QPointF offset = whole.center() - pole;
    const double distance = std::hypot(offset.x(), offset.y());
    const QwtScaleMap radial = scaleMap(QwtPolar::Radius);
    const double perPixel = (radial.s2() - radial.s1()) / (0.5 * whole.width() / factor);
    zoom(QwtPointPolar(std::atan2(-offset.y(), offset.x()), distance * perPixel), factor);
    replot();
    emit viewChanged();
}

void PolarPlot::zoomAt(const QPointF& point, double factor) {
    const double wanted = std::clamp(zoomFactor() * factor, 1e-4, 1.0);
    if (wanted >= 1.0) {
        showWhole();
        return;
    }
    const double growth = zoomFactor() / wanted;
    placePole(point + (plotRect().center() - point) * growth, wanted);
}

void PolarPlot::zoomTo(const QRectF& part) {
    const QRectF seen = canvas()->contentsRect();
    const double growth = std::min(seen.width() / part.width(), seen.height() / part.height());
    const double wanted = zoomFactor() / growth;
    if (wanted > 1e-4 && wanted < 1.0)
        placePole(seen.center() + (plotRect().center() - part.center()) * growth, wanted);
}

void PolarPlot::panBy(const QPointF& offset) {
    if (zoomFactor() < 1.0)
        placePole(plotRect().center() + offset, zoomFactor());
}

void PolarPlot::drawCanvas(QPainter* painter, const QRectF& canvasRect) const {
    drawOnPicture(*painter, canvas()->size(), style_.canvas,
                  [&](QPainter& inside) { QwtPolarPlot::drawCanvas(&inside, canvasRect); });
}

void PolarPlot::keyPressEvent(QKeyEvent* event) {
    if (!navigator_->handleKey(*event))
        QwtPolarPlot::keyPressEvent(event);
}

void PolarPlot::paintCrosshair(QPainter& painter, const QPointF& cursor) const {
    const QPointF pole = plotRect().center();
    const double radius = plotRect().width() / 2.0;
    const QPointF offset = cursor - pole;
    const double distance = std::hypot(offset.x(), offset.y());
    if (distance < 1.0 || distance > radius * 1.05)
        return;
    painter.setPen(QPen(style_.crosshair, 1.0, Qt::DashLine));
    painter.drawLine(pole, pole + offset * (radius / distance));

    const double angle = angleAt(cursor);
    paintReadouts(painter, cursor, QStringLiteral("%1°").arg(angle, 0, 'f', 1), angle, turn_deg,
                  [&](double value) -> std::optional<QPointF> {
                      if (!std::isfinite(radiusOf(value)))
                          return std::nullopt;
                      return canvasPoint(angle, value);
                  });
}

} // namespace smat::gui

#include "moc_PolarPlot.cpp"
