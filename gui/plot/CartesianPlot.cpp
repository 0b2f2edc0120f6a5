#include "gui/plot/CartesianPlot.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <QwtLegend>
#include <QwtLegendLabel>
#include <QwtPlotCanvas>
#include <QwtPlotCurve>
#include <QwtPlotGrid>
#include <QwtPlotLayout>
#include <QwtScaleDraw>
#include <QwtScaleMap>
#include <QwtScaleWidget>
#include <QwtText>

#include "gui/plot/CrosshairOverlay.h"
#include "gui/plot/PlotLook.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {
namespace {

/// Draws runs of drawable samples one by one, so that a missing point leaves a gap.
class GappedCurve : public QwtPlotCurve {
  public:
    using QwtPlotCurve::QwtPlotCurve;

    void drawSeries(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                    const QRectF& canvasRect, int from, int to) const override {
        const int last = to < 0 ? static_cast<int>(dataSize()) - 1 : to;
        const bool xPositive = xMap.transformation() != nullptr;
        const bool yPositive = yMap.transformation() != nullptr;
        int start = std::max(from, 0);
        while (start <= last) {
            while (start <= last && !drawable(start, xPositive, yPositive))
                ++start;
            int end = start;
            while (end + 1 <= last && drawable(end + 1, xPositive, yPositive))
                ++end;
            if (start <= last)
                drawRun(painter, xMap, yMap, canvasRect, start, end);
            start = end + 1;
        }
    }

  private:
    bool drawable(int index, bool xPositive, bool yPositive) const {
        const QPointF p = sample(index);
        return std::isfinite(p.x()) && std::isfinite(p.y()) && (!xPositive || p.x() > 0.0) &&
               (!yPositive || p.y() > 0.0);
    }
    /// A single sample between gaps becomes a dot.
    void drawRun(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                 const QRectF& canvasRect, int from, int to) const {
        if (from < to) {
            QwtPlotCurve::drawSeries(painter, xMap, yMap, canvasRect, from, to);
            return;
        }
        painter->save();
        painter->setPen(Qt::NoPen);
        painter->setBrush(pen().color());
        const QPointF p = sample(from);
        painter->drawEllipse(QPointF(xMap.transform(p.x()), yMap.transform(p.y())), 3.0, 3.0);
        painter->restore();
    }
};

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

} // namespace

CartesianPlot::CartesianPlot(const PlotStyle& style, QWidget* parent)
    : QwtPlot(parent), style_(style) {
    setObjectName("cartesianPlot");
    setFocusPolicy(Qt::StrongFocus);
    setAutoReplot(false);
    auto* sheet = new QwtPlotCanvas(this);
    sheet->setFrameStyle(QFrame::NoFrame);
    sheet->setCursor(Qt::CrossCursor);
    setCanvas(sheet);
    setCanvasBackground(style_.canvas);
    dressPlot(*this, style_);
    plotLayout()->setAlignCanvasToScales(true);

    grid_ = new QwtPlotGrid;
    grid_->enableXMin(true);
    grid_->enableYMin(true);
    grid_->setMajorPen(style_.grid, 1.0);
    grid_->setMinorPen(style_.minorGrid, 1.0);
    grid_->setZ(0.0);
    grid_->attach(this);

    auto* legend = new QwtLegend;
    dressLegend(*legend, style_);
    insertLegend(legend, QwtPlot::BottomLegend);
    connect(legend, &QwtLegend::clicked, this, &CartesianPlot::onLegendClicked);

    overlay_ = new CrosshairOverlay(canvas(), [this](QPainter& p) { paintOverlay(p); });
    canvas()->setMouseTracking(true);
    canvas()->installEventFilter(this);
}

CartesianPlot::~CartesianPlot() = default;

void CartesianPlot::setData(PlotData data) {
    for (const auto& curve : data.curves) {
        if (curve.x.size() != curve.y.size())
            throw irsg::LogicError("curve " + curve.name.toStdString() +
                                   ": x and y differ in length");
    }
    data_ = std::move(data);
    detachItems(QwtPlotItem::Rtti_PlotCurve, true);
    curves_.clear();

    setTitle(plotTitle(data_.title, style_));
    setAxisTitle(xBottom, axisText(data_.xTitle, style_));
    setAxisTitle(yLeft, axisText(data_.yTitle, style_));
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        const Curve& curve = data_.curves[i];
        auto* item = new GappedCurve(curve.name);
        item->setPen(style_.curve(static_cast<int>(i)), 2.0);
        item->setRenderHint(QwtPlotItem::RenderAntialiased);
        item->setLegendAttribute(QwtPlotCurve::LegendShowLine);
        item->setLegendIconSize(QSize(22, 12));
        item->setPaintAttribute(QwtPlotCurve::ClipPolygons);
        item->setSamples(curve.x.data(), curve.y.data(), static_cast<int>(curve.x.size()));
        item->setZ(10.0 + static_cast<double>(i));
        item->attach(this);
        curves_.push_back(item);
    }
    if (legend() != nullptr)
        legend()->setVisible(!data_.curves.empty());
    applyAxes();
    resetView();
    pastViews_.clear();
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
    (axis == xBottom ? data_.xLogarithmic : data_.yLogarithmic) = on;
    applyAxes();
    pastViews_.clear();
    resetView();
}

bool CartesianPlot::isLogarithmic(QwtPlot::Axis axis) const {
    return axis == xBottom ? data_.xLogarithmic : data_.yLogarithmic;
}

void CartesianPlot::setCurveVisible(int curve, bool visible) {
    auto* item = curves_.at(static_cast<std::size_t>(curve));
    item->setVisible(visible);
    QwtText text(data_.curves[static_cast<std::size_t>(curve)].name);
    text.setColor(visible ? style_.text : style_.faintText);
    item->setTitle(text);
    replot();
}

bool CartesianPlot::isCurveVisible(int curve) const {
    return curves_.at(static_cast<std::size_t>(curve))->isVisible();
}

void CartesianPlot::onLegendClicked(const QVariant& item, int) {
    const auto found = std::find(curves_.begin(), curves_.end(), infoToItem(item));
    if (found == curves_.end())
        return;
    const int index = static_cast<int>(found - curves_.begin());
    setCurveVisible(index, !isCurveVisible(index));
}

CartesianPlot::View CartesianPlot::fullView() const {
    const bool xLog = data_.xLogarithmic;
    const bool yLog = data_.yLogarithmic;
    View view{{xLog ? 1.0 : 0.0, xLog ? 10.0 : 1.0}, {yLog ? 1.0 : 0.0, yLog ? 10.0 : 1.0}};
    if (const auto range = rangeOf(data_.curves, &Curve::x, xLog))
        view.x = padded(*range, xLog, 0.0);
    if (const auto range = rangeOf(data_.curves, &Curve::y, yLog))
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
    constexpr std::size_t kept = 100;
    pastViews_.push_back(view());
    if (pastViews_.size() > kept)
        pastViews_.erase(pastViews_.begin());
}

void CartesianPlot::undoZoom() {
    if (pastViews_.empty())
        return;
    const View last = pastViews_.back();
    pastViews_.pop_back();
    setView(last);
}

void CartesianPlot::zoomTo(const QRectF& canvasRect) {
    const double x0 = invTransform(xBottom, canvasRect.left());
    const double x1 = invTransform(xBottom, canvasRect.right());
    const double y0 = invTransform(yLeft, canvasRect.bottom());
    const double y1 = invTransform(yLeft, canvasRect.top());
    // Beyond this the axis could no longer tell its ends apart.
    const auto tooNarrow = [](double low, double high) {
        return !(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)));
    };
    const auto finite = [](double low, double high) {
        return std::isfinite(low) && std::isfinite(high) && std::abs(high) < 1e250;
    };
    if (tooNarrow(x0, x1) || tooNarrow(y0, y1) || !finite(x0, x1) || !finite(y0, y1))
        return;
    setView({{x0, x1}, {y0, y1}});
}

QString CartesianPlot::readoutAt(const QPointF& canvasPoint) const {
    if (!QRectF(canvas()->rect()).contains(canvasPoint))
        return {};
    const double x = invTransform(xBottom, canvasPoint.x());
    QString text = data_.xTitle + ": " + readableNumber(x);
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        if (!curves_[i]->isVisible())
            continue;
        const auto value = data_.curves[i].valueAt(x);
        text += "   " + data_.curves[i].name + ": " + (value ? readableNumber(*value) : "no value");
    }
    return text;
}

CartesianPlot* CartesianPlot::makePaperTwin() const {
    auto* twin = new CartesianPlot(PlotStyle::paper());
    twin->setData(data_);
    twin->setView(view());
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        if (!curves_[i]->isVisible())
            twin->setCurveVisible(static_cast<int>(i), false);
    }
    return twin;
}

void CartesianPlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Backspace:
        undoZoom();
        break;
    case Qt::Key_Home:
        resetView();
        break;
    default:
        QwtPlot::keyPressEvent(event);
    }
}

bool CartesianPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == canvas() && handleMouse(event)) {
        overlay_->update();
        return true;
    }
    return QwtPlot::eventFilter(watched, event);
}

bool CartesianPlot::handleMouse(QEvent* event) {
    const View shown = view();
    const QRectF area(
        QPointF(transform(xBottom, shown.x.minimum), transform(yLeft, shown.y.maximum)),
        QPointF(transform(xBottom, shown.x.maximum), transform(yLeft, shown.y.minimum)));
    switch (event->type()) {
    case QEvent::Wheel: {
        const auto* wheel = static_cast<QWheelEvent*>(event);
        const double factor = std::pow(0.85, wheel->angleDelta().y() / 120.0);
        const QPointF at = wheel->position();
        rememberView();
        zoomTo({at + (area.topLeft() - at) * factor, at + (area.bottomRight() - at) * factor});
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        setFocus();
        if (mouse->button() == Qt::LeftButton)
            dragStart_ = mouse->position();
        if (mouse->button() == Qt::RightButton) {
            rememberView();
            panStart_ = mouse->position();
        }
        return true;
    }
    case QEvent::MouseMove: {
        cursor_ = static_cast<QMouseEvent*>(event)->position();
        if (panStart_) {
            zoomTo(area.translated(*panStart_ - *cursor_));
            panStart_ = cursor_;
        }
        emit readoutChanged(readoutAt(*cursor_));
        return true;
    }
    case QEvent::MouseButtonRelease: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::LeftButton && dragStart_) {
            const QRectF box = QRectF(*dragStart_, mouse->position()).normalized();
            dragStart_.reset();
            if (box.width() > 5.0 && box.height() > 5.0) {
                rememberView();
                zoomTo(box);
            }
        }
        if (mouse->button() == Qt::RightButton)
            panStart_.reset();
        return true;
    }
    case QEvent::MouseButtonDblClick:
        dragStart_.reset();
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

void CartesianPlot::paintOverlay(QPainter& painter) const {
    if (!cursor_)
        return;
    const QRectF area = canvas()->rect();
    if (dragStart_) {
        QColor fill = palette().color(QPalette::Highlight);
        painter.setPen(fill);
        fill.setAlphaF(0.18F);
        painter.setBrush(fill);
        painter.drawRect(QRectF(*dragStart_, *cursor_).normalized());
        return;
    }
    painter.setPen(QPen(style_.crosshair, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(cursor_->x(), 0.0), QPointF(cursor_->x(), area.bottom()));
    painter.drawLine(QPointF(0.0, cursor_->y()), QPointF(area.right(), cursor_->y()));

    const double x = invTransform(xBottom, cursor_->x());
    std::vector<ReadoutLine> lines{{QColor(), data_.xTitle + "  " + readableNumber(x)}};
    for (std::size_t i = 0; i < data_.curves.size(); ++i) {
        const auto value = data_.curves[i].valueAt(x);
        if (!curves_[i]->isVisible() || !value)
            continue;
        const QColor color = style_.curve(static_cast<int>(i));
        painter.setPen(QPen(style_.canvas, 1.5));
        painter.setBrush(color);
        if (!data_.yLogarithmic || *value > 0.0)
            painter.drawEllipse(QPointF(cursor_->x(), transform(yLeft, *value)), 4.5, 4.5);
        lines.push_back({color, data_.curves[i].name + "  " + readableNumber(*value)});
    }
    drawReadoutBox(painter, *cursor_, area, lines, style_.background, style_.frame, style_.text);
}

} // namespace smat::gui
