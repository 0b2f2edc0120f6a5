#include "gui/plot/PolarPlot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <QwtLegend>
#include <QwtPointPolar>
#include <QwtPolarCanvas>
#include <QwtPolarGrid>
#include <QwtScaleDraw>
#include <QwtScaleEngine>
#include <QwtScaleMap>

#include "gui/plot/CrosshairOverlay.h"
#include "gui/plot/PlotLook.h"
#include "gui/plot/PolarItems.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {
namespace {

constexpr double turn_deg = 360.0;
constexpr double floor_dB = -40.0;

/// Some five circles in what is seen, whatever the zoom: more would run into each other's numbers.
class FewCircles : public QwtLinearScaleEngine {
  public:
    QwtScaleDiv divideScale(double x1, double x2, int, int, double) const override {
        return QwtLinearScaleEngine::divideScale(x1, x2, 5, 2, 0.0);
    }
};

/// Goes all the way round but for its last step: then the first sample is drawn again.
bool goesRound(const Curve& curve) {
    if (curve.x.size() < 4)
        return false;
    const double step = std::abs(curve.x[1] - curve.x[0]);
    const double span = std::abs(curve.x.back() - curve.x.front());
    return span < turn_deg && span + 1.5 * step >= turn_deg;
}

} // namespace

PolarPlot::PolarPlot(const PlotStyle& style, QWidget* parent)
    : QwtPolarPlot(parent), style_(style) {
    setObjectName("polarPlot");
    setFocusPolicy(Qt::StrongFocus);
    setAutoReplot(false);
    setPlotBackground(style_.canvas);
    setAzimuthOrigin(std::numbers::pi / 2.0);
    setContentsMargins(12, 10, 12, 10);
    setMinimumSize(320, 320);

    QPalette colours = palette();
    colours.setColor(QPalette::Window, style_.background);
    colours.setColor(QPalette::WindowText, style_.text);
    colours.setColor(QPalette::Text, style_.text);
    setPalette(colours);
    setAutoFillBackground(true);
    canvas()->setPalette(colours);
    canvas()->setFrameStyle(QFrame::NoFrame);
    canvas()->setCursor(Qt::CrossCursor);
    canvas()->setMouseTracking(true);
    canvas()->installEventFilter(this);

    setScaleEngine(QwtPolar::Radius, new FewCircles);
    auto* grid = new QwtPolarGrid;
    grid->setPen(QPen(style_.text));
    grid->setMajorGridPen(QPen(style_.grid, 1.0));
    grid->setMinorGridPen(QPen(style_.minorGrid, 1.0));
    for (int scale = 0; scale < QwtPolar::ScaleCount; ++scale) {
        grid->showGrid(scale, true);
        grid->showMinorGrid(scale, scale == QwtPolar::Radius);
    }
    for (int axis = 0; axis < QwtPolar::AxesCount; ++axis)
        grid->showAxis(axis, axis == QwtPolar::AxisAzimuth || axis == QwtPolar::AxisRight);
    grid->setFont(plotFont(0.9));
    grid->setAxisPen(QwtPolar::AxisAzimuth, QPen(style_.text));
    grid->setAxisPen(QwtPolar::AxisRight, QPen(style_.faintText));
    grid->setAzimuthScaleDraw(new AngleLabels);
    grid->setScaleDraw(QwtPolar::AxisRight, new NumberLabels);
    grid->setDisplayFlag(QwtPolarGrid::HideMaxRadiusLabel, false);
    grid->setDisplayFlag(QwtPolarGrid::SmartOriginLabel, true);
    grid->attach(this);

    auto* legend = new QwtLegend;
    dressLegend(*legend, style_);
    insertLegend(legend, QwtPolarPlot::BottomLegend);
    connect(legend, &QwtLegend::clicked, this, [this](const QVariant& item, int) {
        const auto found = std::find(curves_.begin(), curves_.end(), infoToItem(item));
        const int index = static_cast<int>(found - curves_.begin());
        if (found != curves_.end())
            setCurveVisible(index, !isCurveVisible(index));
    });
    overlay_ = new CrosshairOverlay(canvas(), [this](QPainter& p) { paintOverlay(p); });
}

PolarPlot::~PolarPlot() = default;

void PolarPlot::setData(PolarData data) {
    for (const auto& curve : data.curves) {
        if (curve.x.size() != curve.y.size())
            throw irsg::LogicError("curve " + curve.name.toStdString() +
                                   ": x and y differ in length");
    }
    data_ = std::move(data);
    setTitle(plotTitle(data_.title, style_));
    // A scale that runs backwards turns clockwise.
    setScale(QwtPolar::Azimuth, data_.clockwise ? turn_deg : 0.0, data_.clockwise ? 0.0 : turn_deg,
             data_.clockwise ? -30.0 : 30.0);
    rebuildCurves();
}

void PolarPlot::setRadiusScale(RadiusScale scale) {
    radiusScale_ = scale;
    rebuildCurves();
}

double PolarPlot::radiusOf(double value) const {
    if (radiusScale_ == RadiusScale::linear)
        return value;
    if (!(value > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    return std::max(10.0 * std::log10(value / largest_), floor_dB);
}

void PolarPlot::rebuildCurves() {
    std::vector<bool> visible;
    for (const auto* curve : curves_)
        visible.push_back(curve->isVisible());
    detachItems(QwtPolarItem::Rtti_PolarCurve, true);
    curves_.clear();

    // The radius ends at a round number above the largest value; it begins at 0, or below where a
    // contrast is negative.
    const bool decibel = radiusScale_ == RadiusScale::decibel;
    const auto range = rangeOf(data_.curves, &Curve::y, decibel);
    largest_ = range ? range->maximum : 1.0;
    if (decibel) {
        setScale(QwtPolar::Radius, floor_dB, 0.0);
    } else {
        double low = range ? std::min(range->minimum, 0.0) : 0.0;
        double high = range ? std::max(range->maximum, 0.0) : 1.0;
        if (!(high > low))
            high = low + 1.0;
        double step = 0.0;
        QwtLinearScaleEngine().autoScale(5, low, high, step);
        setScale(QwtPolar::Radius, low, high);
    }
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        const Curve& curve = data_.curves[i];
        QVector<QwtPointPolar> points;
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            if (std::isfinite(curve.x[k]))
                points.push_back({curve.x[k], radiusOf(curve.y[k])});
        }
        if (goesRound(curve))
            points.push_back({curve.x.front() + turn_deg, radiusOf(curve.y.front())});
        auto* item = new GappedPolarCurve(curve.name);
        item->setStyle(QwtPolarCurve::Lines);
        item->setPen(QPen(style_.curve(static_cast<int>(i)), 2.0));
        item->setLegendAttribute(QwtPolarCurve::LegendShowLine, true);
        item->setLegendIconSize(QSize(22, 12));
        item->setRenderHint(QwtPolarItem::RenderAntialiased);
        item->setItemAttribute(QwtPolarItem::Legend);
        item->setData(new QwtArraySeriesData<QwtPointPolar>(points));
        item->setZ(10.0 + static_cast<double>(i));
        item->attach(this);
        curves_.push_back(item);
    }
    QString radius = data_.radiusTitle;
    if (decibel)
        radius += QStringLiteral(", dB below %1").arg(readableNumber(largest_));
    if (const int left = samplesLeftOut(); left > 0)
        radius += QStringLiteral(" (%1 values not above 0 left out)").arg(left);
    notes_ = std::make_unique<PolarNotes>(style_, data_.directionNote, data_.clockwise, radius);
    notes_->attach(this);

    for (std::size_t i = 0; i < visible.size() && i < curves_.size(); ++i) {
        if (!visible[i])
            setCurveVisible(static_cast<int>(i), false);
    }
    resetView();
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

void PolarPlot::setCurveVisible(int curve, bool visible) {
    auto* item = curves_.at(static_cast<std::size_t>(curve));
    item->setVisible(visible);
    QwtText text(data_.curves[static_cast<std::size_t>(curve)].name);
    text.setColor(visible ? style_.text : style_.faintText);
    item->setTitle(text);
    replot();
}

bool PolarPlot::isCurveVisible(int curve) const {
    return curves_.at(static_cast<std::size_t>(curve))->isVisible();
}

void PolarPlot::resetView() {
    unzoom();
    replot();
}

QPointF PolarPlot::canvasPoint(double angle_deg, double value) const {
    const QwtScaleMap azimuth = scaleMap(QwtPolar::Azimuth);
    const QwtScaleMap radial = scaleMap(QwtPolar::Radius);
    const double angle = azimuth.transform(angle_deg);
    const double distance = radial.transform(radiusOf(value));
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
    QString text = QStringLiteral("%1°").arg(angle, 0, 'f', 1);
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        if (!curves_[i]->isVisible())
            continue;
        const auto value = data_.curves[i].valueAt(angle, turn_deg);
        text += "   " + data_.curves[i].name + ": " + (value ? readableNumber(*value) : "no value");
    }
    return text;
}

PolarPlot* PolarPlot::makePaperTwin() const {
    auto* twin = new PolarPlot(PlotStyle::paper());
    twin->radiusScale_ = radiusScale_;
    twin->setData(data_);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        if (!curves_[i]->isVisible())
            twin->setCurveVisible(static_cast<int>(i), false);
    }
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
}

void PolarPlot::zoomAt(const QPointF& cursor, double factor) {
    const double wanted = std::clamp(zoomFactor() * factor, 1e-4, 1.0);
    if (wanted >= 1.0) {
        resetView();
        return;
    }
    const double growth = zoomFactor() / wanted;
    placePole(cursor + (plotRect().center() - cursor) * growth, wanted);
}

void PolarPlot::panBy(const QPointF& offset) {
    if (zoomFactor() < 1.0)
        placePole(plotRect().center() + offset, zoomFactor());
}

bool PolarPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == canvas() && handleMouse(event)) {
        overlay_->update();
        return true;
    }
    return QwtPolarPlot::eventFilter(watched, event);
}

bool PolarPlot::handleMouse(QEvent* event) {
    switch (event->type()) {
    case QEvent::Wheel: {
        const auto* wheel = static_cast<QWheelEvent*>(event);
        zoomAt(wheel->position(), std::pow(0.85, wheel->angleDelta().y() / 120.0));
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::RightButton)
            panStart_ = mouse->position();
        return true;
    }
    case QEvent::MouseMove:
        cursor_ = static_cast<QMouseEvent*>(event)->position();
        if (panStart_) {
            panBy(*cursor_ - *panStart_);
            panStart_ = cursor_;
        }
        emit readoutChanged(readoutAt(*cursor_));
        return true;
    case QEvent::MouseButtonRelease:
        panStart_.reset();
        return true;
    case QEvent::MouseButtonDblClick:
        resetView();
        return true;
    case QEvent::Leave:
        cursor_.reset();
        overlay_->update();
        emit readoutChanged({});
        return false;
    default:
        return false;
    }
}

void PolarPlot::paintOverlay(QPainter& painter) const {
    if (!cursor_ || panStart_)
        return;
    const QPointF pole = plotRect().center();
    const double radius = plotRect().width() / 2.0;
    const QPointF offset = *cursor_ - pole;
    const double distance = std::hypot(offset.x(), offset.y());
    if (distance < 1.0 || distance > radius * 1.05)
        return;
    painter.setPen(QPen(style_.crosshair, 1.0, Qt::DashLine));
    painter.drawLine(pole, pole + offset * (radius / distance));

    const double angle = angleAt(*cursor_);
    std::vector<ReadoutLine> lines{{QColor(), QStringLiteral("%1°").arg(angle, 0, 'f', 1)}};
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        const auto value = data_.curves[i].valueAt(angle, turn_deg);
        if (!curves_[i]->isVisible() || !value)
            continue;
        const QColor color = style_.curve(static_cast<int>(i));
        painter.setPen(QPen(style_.canvas, 1.5));
        painter.setBrush(color);
        if (std::isfinite(radiusOf(*value)))
            painter.drawEllipse(canvasPoint(angle, *value), 4.5, 4.5);
        lines.push_back({color, data_.curves[i].name + "  " + readableNumber(*value)});
    }
    drawReadoutBox(painter, *cursor_, canvas()->rect(), lines, style_.background, style_.frame,
                   style_.text);
}

} // namespace smat::gui
