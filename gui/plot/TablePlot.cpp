#include "gui/plot/TablePlot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "gui/plot/PlotExport.h"
#include "gui/plot/PlotLook.h"

namespace smat::gui {

namespace {

constexpr double keyTurn_deg = 10.0;

} // namespace

TablePlot::TablePlot(std::shared_ptr<const ResultTable> table, QWidget* parent)
    : QWidget(parent), drawing_(std::move(table)) {
    setObjectName("tablePlot");
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(420, 300);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(tr("Drag the ball, or press the arrows, to turn it"));
}

double TablePlot::letter() const {
    return QFontMetricsF(plotFont(), this).height();
}

void TablePlot::refresh() {
    update();
    emit changed();
}

QPointF TablePlot::ballCentre() const {
    return drawing_.ballIn(rect(), letter()).center();
}

int TablePlot::directionAt(const QPointF& point) const {
    return drawing_.directionAt(point, rect(), letter());
}

void TablePlot::turn(double azimuth_deg, double elevation_deg) {
    drawing_.turnBall(drawing_.ballAzimuth_deg() + azimuth_deg,
                      drawing_.ballElevation_deg() + elevation_deg);
    refresh();
}

void TablePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const PlotStyle style = PlotStyle::screen(palette());
    drawing_.paint(painter, rect(), style);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void TablePlot::mousePressEvent(QMouseEvent* event) {
    const QRectF ball = drawing_.ballIn(rect(), letter());
    const QPointF off = event->position() - ball.center();
    const double radius = 0.5 * ball.width();
    if (event->button() == Qt::LeftButton && QPointF::dotProduct(off, off) <= radius * radius)
        heldAt_ = event->position();
}

void TablePlot::mouseMoveEvent(QMouseEvent* event) {
    if (heldAt_) {
        // What is held stays below the mouse, in the middle of the ball.
        const double perPixel =
            360.0 / (3.14159265358979 * std::max(1.0, drawing_.ballIn(rect(), letter()).width()));
        const QPointF way = event->position() - *heldAt_;
        heldAt_ = event->position();
        turn(way.x() * perPixel, way.y() * perPixel);
    }
    emit hovered(drawing_.readout(directionAt(event->position())));
}

void TablePlot::mouseReleaseEvent(QMouseEvent*) {
    heldAt_.reset();
}

void TablePlot::leaveEvent(QEvent*) {
    emit hovered({});
}

void TablePlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return turn(-keyTurn_deg, 0.0);
    case Qt::Key_Right:
        return turn(keyTurn_deg, 0.0);
    case Qt::Key_Up:
        return turn(0.0, keyTurn_deg);
    case Qt::Key_Down:
        return turn(0.0, -keyTurn_deg);
    default:
        QWidget::keyPressEvent(event);
    }
}

void TablePlot::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void TablePlot::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void exportTable(const TableDrawing& drawing, const std::filesystem::path& file, QSize size) {
    exportDrawing(
        file, drawing.title, size, [&] { return drawing.csv(); },
        [&](QPainter& painter, const QRectF& area) {
            drawing.paint(painter, area, PlotStyle::paper());
        });
}

QImage tablePicture(const TableDrawing& drawing, QSize size) {
    return drawnPicture(size, [&](QPainter& painter, const QRectF& area) {
        drawing.paint(painter, area, PlotStyle::paper());
    });
}

} // namespace smat::gui

#include "moc_TablePlot.cpp"
