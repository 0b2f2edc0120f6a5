#include "gui/database/NodePlot.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QwtLegend>
#include <QwtPlotCanvas>
#include <QwtPlotCurve>
#include <QwtPlotGrid>
#include <QwtPlotLayout>
#include <QwtPlotMarker>
#include <QwtSymbol>

#include "gui/plot/PlotLook.h"

namespace smat::gui {
namespace {

constexpr double reach_px = 10.0;

QwtPlotCurve* attached(QwtPlot* plot, double z) {
    auto* curve = new QwtPlotCurve;
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->setItemAttribute(QwtPlotItem::Legend, false);
    curve->setZ(z);
    curve->attach(plot);
    return curve;
}

/// Where a plot is low a name below the numbers would be cut; it heads the column of the table,
/// too.
void nameAxes(QwtPlot& plot, const NodeRules& rules, const PlotStyle& style) {
    const bool isLow = plot.height() < 11 * plot.fontMetrics().height();
    plot.setAxisTitle(QwtPlot::xBottom, isLow ? QwtText() : axisText(rules.xTitle(), style));
    plot.setAxisTitle(QwtPlot::yLeft, axisText(rules.yTitle(), style));
}

} // namespace

NodePlot::NodePlot(QWidget* parent) : QwtPlot(parent) {
    setObjectName("nodePlot");
    setFocusPolicy(Qt::StrongFocus);
    setAutoReplot(false);
    setMinimumSize(190, 100);
    auto* sheet = new QwtPlotCanvas(this);
    sheet->setFrameStyle(QFrame::NoFrame);
    setCanvas(sheet);
    plotLayout()->setAlignCanvasToScales(true);
    grid_ = new QwtPlotGrid;
    grid_->attach(this);
    heldBefore_ = attached(this, 9.0);
    heldAfter_ = attached(this, 9.0);
    line_ = attached(this, 10.0);
    line_->setItemAttribute(QwtPlotItem::Legend, true);
    dots_ = attached(this, 11.0);
    dots_->setStyle(QwtPlotCurve::NoCurve);
    chosen_ = attached(this, 12.0);
    chosen_->setStyle(QwtPlotCurve::NoCurve);
    label_ = new QwtPlotMarker;
    label_->setZ(13.0);
    label_->attach(this);
    canvas()->setMouseTracking(true);
    canvas()->installEventFilter(this);
    canvas()->setToolTip(tr("Drag a node to move it (Shift: only its value), double click to add "
                            "one, Delete to remove it"));
    dress();
}

NodePlot::~NodePlot() = default;

void NodePlot::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    // As many numbers as there is room for.
    constexpr int number_px = 40, line_px = 26;
    setAxisMaxMajor(xBottom, std::clamp(canvas()->width() / number_px, 3, 8));
    setAxisMaxMajor(yLeft, std::clamp(canvas()->height() / line_px, 3, 8));
    nameAxes(*this, rules_, PlotStyle::screen(QApplication::palette()));
    replot();
}

void NodePlot::dress() {
    palette_.taken();
    const PlotStyle style = PlotStyle::screen(QApplication::palette());
    setCanvasBackground(style.canvas);
    dressPlot(*this, style);
    setContentsMargins(4, 6, 10, 4);
    grid_->setMajorPen(style.grid, 1.0);
    nameAxes(*this, rules_, style);
    if (!backdrop_.empty() && legend() == nullptr)
        insertLegend(new QwtLegend, QwtPlot::TopLegend);
    if (auto* texts = qobject_cast<QwtLegend*>(legend())) {
        dressLegend(*texts, style);
        texts->setDefaultItemMode(QwtLegendData::ReadOnly);
    }

    const QColor color = style.curve(editedColor_);
    line_->setPen(color, 2.2);
    line_->setTitle(rules_.ySymbol.isEmpty() ? rules_.yName : rules_.ySymbol);
    line_->setLegendAttribute(QwtPlotCurve::LegendShowLine);
    line_->setLegendIconSize(QSize(18, 10));
    heldBefore_->setPen(color, 1.4, Qt::DotLine);
    heldAfter_->setPen(color, 1.4, Qt::DotLine);
    dots_->setSymbol(
        new QwtSymbol(QwtSymbol::Ellipse, style.canvas, QPen(color, 2.0), QSize(9, 9)));
    chosen_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, color, QPen(color, 2.0), QSize(12, 12)));
    for (std::size_t i = 0; i < behind_.size(); ++i) {
        const bool given = i < backdropColors_.size();
        QColor faint = style.curve(given ? backdropColors_[i] : static_cast<int>(i) + 1);
        faint.setAlphaF(0.75F);
        behind_[i]->setPen(faint, 1.5, Qt::DashLine);
    }
}

void NodePlot::setRules(NodeRules rules) {
    rules_ = std::move(rules);
    dress();
    fitAxes();
    drawNodes();
}

void NodePlot::setCurveColors(int edited, std::vector<int> backdrop) {
    editedColor_ = edited;
    backdropColors_ = std::move(backdrop);
    dress();
}

void NodePlot::setLeastView(std::optional<Interval> x, std::optional<Interval> y) {
    leastX_ = x;
    leastY_ = y;
    fitAxes();
}

void NodePlot::setBackdrop(std::vector<Curve> curves) {
    for (auto* curve : behind_) {
        curve->detach();
        delete curve;
    }
    behind_.clear();
    backdrop_ = std::move(curves);
    for (const auto& curve : backdrop_) {
        auto* item = attached(this, 5.0);
        item->setTitle(curve.name);
        item->setItemAttribute(QwtPlotItem::Legend, true);
        item->setLegendAttribute(QwtPlotCurve::LegendShowLine);
        item->setLegendIconSize(QSize(18, 10));
        item->setSamples(curve.x.data(), curve.y.data(), static_cast<int>(curve.x.size()));
        behind_.push_back(item);
    }
    dress();
    fitAxes();
    replot();
}

void NodePlot::setNodes(const Nodes& nodes) {
    nodes_ = nodes;
    line_->setItemAttribute(QwtPlotItem::Legend, !nodes_.empty());
    if (selected_ >= static_cast<int>(nodes_.size()))
        selected_ = -1;
    if (!dragging_)
        fitAxes();
    drawNodes();
}

void NodePlot::fitAxes() {
    Interval x = leastX_.value_or(Interval{0.0, 1.0});
    Interval y = leastY_.value_or(Interval{0.0, 1.0});
    bool anyX = leastX_.has_value();
    bool anyY = leastY_.has_value();
    const auto take = [](Interval& range, bool& any, double value) {
        range = any ? Interval{std::min(range.minimum, value), std::max(range.maximum, value)}
                    : Interval{value, value};
        any = true;
    };
    for (const auto& node : nodes_) {
        take(x, anyX, node.x);
        take(y, anyY, node.y);
    }
    const auto widen = [](Interval& range, double part) {
        const double span = range.maximum - range.minimum;
        const double pad = span > 0.0 ? span * part : std::max(std::abs(range.maximum), 1.0) * 0.2;
        range = {range.minimum - pad, range.maximum + pad};
    };
    if (!leastX_ || x.maximum <= x.minimum)
        widen(x, 0.05);
    widen(y, 0.05);
    setAxisScale(xBottom, x.minimum, x.maximum);
    setAxisScale(yLeft, y.minimum, y.maximum);
    updateAxes();
}

/// Axes reach to the chosen node, wherever it is dragged.
void NodePlot::growAxes() {
    const Node& node = nodes_[static_cast<std::size_t>(selected_)];
    const auto reach = [this](QwtAxisId axis, double value) {
        const QwtInterval now = axisInterval(axis);
        if (now.contains(value))
            return;
        const double pad = 0.05 * now.width();
        setAxisScale(axis, std::min(now.minValue(), value - pad),
                     std::max(now.maxValue(), value + pad));
    };
    reach(xBottom, node.x);
    reach(yLeft, node.y);
    updateAxes();
}

void NodePlot::drawNodes() {
    QList<QPointF> points;
    for (const auto& node : nodes_)
        points << QPointF(node.x, node.y);
    line_->setSamples(points);
    line_->setItemAttribute(QwtPlotItem::Legend, !points.isEmpty());
    dots_->setSamples(points);
    const bool chosen = selected_ >= 0 && selected_ < points.size();
    chosen_->setSamples(chosen ? QList<QPointF>{points[selected_]} : QList<QPointF>());

    // What is clamped outside the nodes.
    const double left = axisInterval(xBottom).minValue();
    const double right = axisInterval(xBottom).maxValue();
    heldBefore_->setSamples(
        points.isEmpty() ? points : QList{QPointF(left, points.front().y()), points.front()});
    heldAfter_->setSamples(
        points.isEmpty() ? points : QList{points.back(), QPointF(right, points.back().y())});
    label_->setVisible(chosen);
    if (chosen) {
        const PlotStyle style = PlotStyle::screen(QApplication::palette());
        const QPointF at = points[selected_];
        QwtText words(QStringLiteral("%1 %2, %3 %4")
                          .arg(QString::number(at.x(), 'g', 6), rules_.xUnit,
                               QString::number(at.y(), 'g', 5), rules_.yUnit)
                          .trimmed(),
                      QwtText::PlainText);
        words.setColor(style.text);
        QColor back = style.canvas;
        back.setAlphaF(0.85F);
        words.setBackgroundBrush(back);
        label_->setValue(at);
        label_->setLabel(words);
        const bool atRight = at.x() > (left + right) / 2.0;
        const bool top =
            at.y() > axisInterval(yLeft).minValue() + 0.8 * axisInterval(yLeft).width();
        label_->setLabelAlignment((atRight ? Qt::AlignLeft : Qt::AlignRight) |
                                  (top ? Qt::AlignBottom : Qt::AlignTop));
        label_->setSpacing(8);
    }
    replot();
}

void NodePlot::selectNode(int node) {
    if (node == selected_ || node >= static_cast<int>(nodes_.size()))
        return;
    selected_ = node;
    drawNodes();
    emit nodeSelected(node);
}

QPointF NodePlot::positionOf(int node) const {
    const Node& at = nodes_.at(static_cast<std::size_t>(node));
    return {transform(xBottom, at.x), transform(yLeft, at.y)};
}

int NodePlot::nodeNear(const QPointF& at) const {
    int nearest = -1;
    double least = reach_px;
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
        const QPointF away = positionOf(i) - at;
        const double distance = std::hypot(away.x(), away.y());
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

Node NodePlot::underMouse(const QPointF& at) const {
    // As fine as a pixel tells, so that a drag gives numbers that a person would type.
    const auto rounded = [](double value, double perPixel) {
        const double step = std::pow(10.0, std::floor(std::log10(std::abs(perPixel))));
        return QString::number(std::round(value / step) * step, 'g', 6).toDouble();
    };
    const QwtScaleMap x = dragging_ ? dragX_ : canvasMap(xBottom);
    const QwtScaleMap y = dragging_ ? dragY_ : canvasMap(yLeft);
    return {rounded(x.invTransform(at.x()), x.sDist() / std::max(x.pDist(), 1.0)),
            rounded(y.invTransform(at.y()), y.sDist() / std::max(y.pDist(), 1.0))};
}

void NodePlot::move(Node wanted) {
    const auto index = static_cast<std::size_t>(selected_);
    const Node moved = rules_.bounded(nodes_, index, wanted);
    if (moved == nodes_[index])
        return;
    nodes_[index] = moved;
    growAxes();
    drawNodes();
    emit edited(nodes_, moved.x);
}

void NodePlot::add(const QPointF& at) {
    const Node wanted = underMouse(at);
    const auto behind = std::find_if(nodes_.begin(), nodes_.end(),
                                     [&](const Node& node) { return node.x >= wanted.x; });
    if (behind != nodes_.end() && behind->x == wanted.x)
        return;
    const auto place = behind - nodes_.begin();
    Nodes more = nodes_;
    more.insert(more.begin() + place, wanted);
    more[static_cast<std::size_t>(place)] =
        rules_.bounded(more, static_cast<std::size_t>(place), wanted);
    if (!rules_.problemOf(more).isEmpty())
        return;
    nodes_ = more;
    selected_ = static_cast<int>(place);
    drawNodes();
    emit added(nodes_, nodes_[static_cast<std::size_t>(place)].x);
}

void NodePlot::remove() {
    if (selected_ < 0 || nodes_.size() <= rules_.fewest)
        return;
    const double x = nodes_[static_cast<std::size_t>(selected_)].x;
    nodes_.erase(nodes_.begin() + selected_);
    selected_ = std::min(selected_, static_cast<int>(nodes_.size()) - 1);
    drawNodes();
    emit removed(nodes_, x);
}

bool NodePlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == canvas() && !readOnly_ && handleMouse(event))
        return true;
    return QwtPlot::eventFilter(watched, event);
}

bool NodePlot::handleMouse(QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        setFocus();
        if (mouse->button() != Qt::LeftButton)
            return false;
        selectNode(nodeNear(mouse->position()));
        dragX_ = canvasMap(xBottom);
        dragY_ = canvasMap(yLeft);
        dragging_ = selected_ >= 0 && nodeNear(mouse->position()) == selected_;
        return true;
    }
    case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (dragging_) {
            Node wanted = underMouse(mouse->position());
            if (mouse->modifiers() & Qt::ShiftModifier)
                wanted.x = nodes_[static_cast<std::size_t>(selected_)].x;
            move(wanted);
            return true;
        }
        const int near = nodeNear(mouse->position());
        canvas()->setCursor(near >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor);
        return false;
    }
    case QEvent::MouseButtonRelease:
        if (std::exchange(dragging_, false)) {
            fitAxes();
            drawNodes();
            emit dragEnded();
        }
        return true;
    case QEvent::MouseButtonDblClick: {
        const QPointF at = static_cast<QMouseEvent*>(event)->position();
        if (nodeNear(at) < 0)
            add(at);
        return true;
    }
    default:
        return false;
    }
}

void NodePlot::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(nodes_.size()) - 1;
    const auto step = [&](double sign) {
        if (selected_ < 0 || readOnly_)
            return;
        Node wanted = nodes_[static_cast<std::size_t>(selected_)];
        wanted.y = QString::number(wanted.y + sign * axisInterval(yLeft).width() * 0.01, 'g', 5)
                       .toDouble();
        move(wanted);
    };
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (!readOnly_)
            remove();
        break;
    case Qt::Key_Left:
        selectNode(std::max(selected_ - 1, std::min(0, last)));
        break;
    case Qt::Key_Right:
        selectNode(std::min(selected_ + 1, last));
        break;
    case Qt::Key_Up:
        step(1.0);
        break;
    case Qt::Key_Down:
        step(-1.0);
        break;
    default:
        QwtPlot::keyPressEvent(event);
    }
}

void NodePlot::keyReleaseEvent(QKeyEvent* event) {
    // A key that is held down is one step.
    if (!event->isAutoRepeat() && (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down))
        emit dragEnded();
    QwtPlot::keyReleaseEvent(event);
}

void NodePlot::changeEvent(QEvent* event) {
    QwtPlot::changeEvent(event);
    palette_.follow(*this, *event, [this] {
        dress();
        drawNodes();
    });
}

} // namespace smat::gui

#include "moc_NodePlot.cpp"
