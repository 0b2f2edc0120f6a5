#include "gui/scenario/PlanView.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

constexpr int margin_px = 34;
constexpr double leastExtent_m = 10.0;

/// 1, 2 or 5 times a power of ten, not below `least`.
double roundAbove(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least)
            return step * power;
    return 10.0 * power;
}

} // namespace

PlanView::PlanView(QWidget* parent) : QWidget(parent) {
    setObjectName("planView");
    setMinimumSize(200, 150);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plan"));
    setToolTip(tr("From above, north up. Wheel zooms, drag moves, double click shows all"));
}

void PlanView::setScenario(std::shared_ptr<const EditedScenario> state) {
    state_ = std::move(state);
    const Scenario& scenario = state_->scenario;
    paths_ = {};
    paths_.scenario = scenario;
    const auto pathOf = [&](const std::filesystem::path& file, const irsg::Pose& pose) {
        const TrajectoryTable* table = file.empty() ? nullptr : state_->table(file);
        return table != nullptr && !table->rows.empty() ? Trajectory(*table) : Trajectory(pose);
    };
    for (const ScenarioEntity& entity : scenario.entities)
        paths_.paths.push_back(pathOf(entity.trajectory, entity.pose));
    for (const ScenarioSensor& sensor : scenario.sensors)
        paths_.sensors.push_back({.settings = {},
                                  .scene = {},
                                  .path = pathOf(sensor.trajectory, irsg::Pose()),
                                  .warnings = {}});
    update();
}

void PlanView::setMoment(double time_s, std::size_t sensor, double fov_deg) {
    time_s_ = time_s;
    sensor_ = sensor;
    fov_deg_ = fov_deg;
    update();
}

void PlanView::showAll() {
    zoom_ = 1.0;
    shift_ = {};
    update();
}

std::optional<PlanView::Place> PlanView::entityAt(std::size_t entity) const {
    const auto at = paths_.entityAt(entity, time_s_);
    if (!at)
        return std::nullopt;
    return Place{{at->pose.position_m.x, at->pose.position_m.y},
                 at->pose.attitude.yaw_rad,
                 at->pose.position_m.z};
}

std::optional<PlanView::Place> PlanView::sensorAt(std::size_t sensor) const {
    const auto at = paths_.sensorAt(sensor, time_s_);
    if (!at)
        return std::nullopt;
    Place place{{at->position_m.x, at->position_m.y}, 0.0, at->position_m.z};
    irsg::Vec3 along = at->axes * irsg::Vec3{0, 1, 0};
    const std::string& tracked = paths_.scenario.sensors[sensor].track;
    if (!tracked.empty()) {
        const auto target = paths_.entityAt(paths_.scenario.findEntity(tracked).value(), time_s_);
        if (!target)
            return std::nullopt;
        along = target->pose.position_m - at->position_m;
    }
    place.heading_rad = std::atan2(-along.x, along.y);
    return place;
}

QRectF PlanView::extent_m() const {
    double west = 1e300, east = -1e300, south = 1e300, north = -1e300;
    const auto take = [&](double x, double y) {
        west = std::min(west, x);
        east = std::max(east, x);
        south = std::min(south, y);
        north = std::max(north, y);
    };
    for (const auto& [file, table] : state_->trajectories)
        for (const TrajectoryTable::Row& row : table.rows)
            take(row[TrajectoryTable::x], row[TrajectoryTable::y]);
    for (const ScenarioEntity& entity : state_->scenario.entities)
        if (entity.trajectory.empty())
            take(entity.pose.position_m.x, entity.pose.position_m.y);
    for (const ScenarioSensor& sensor : state_->scenario.sensors)
        if (sensor.mount == MountKind::world)
            take(sensor.offset.position_m.x, sensor.offset.position_m.y);
    if (west > east)
        return {-leastExtent_m, -leastExtent_m, 2.0 * leastExtent_m, 2.0 * leastExtent_m};
    QRectF extent(QPointF(west, south), QPointF(east, north));
    const double least = std::max({leastExtent_m, 0.02 * extent.width(), 0.02 * extent.height()});
    if (extent.width() < least)
        extent.adjust(-least / 2.0, 0.0, least / 2.0, 0.0);
    if (extent.height() < least)
        extent.adjust(0.0, -least / 2.0, 0.0, least / 2.0);
    return extent;
}

double PlanView::scale() const {
    const QRectF extent = extent_m();
    return zoom_ * std::min(std::max(width() - 2 * margin_px, 10) / extent.width(),
                            std::max(height() - 2 * margin_px, 10) / extent.height());
}

QPointF PlanView::pointOf(double east_m, double north_m) const {
    const QPointF centre = extent_m().center();
    return QPointF(width() / 2.0, height() / 2.0) + shift_ +
           scale() * QPointF(east_m - centre.x(), centre.y() - north_m);
}

QPointF PlanView::metresAt(const QPointF& point) const {
    const QPointF centre = extent_m().center();
    const QPointF off = (point - shift_ - QPointF(width() / 2.0, height() / 2.0)) / scale();
    return {centre.x() + off.x(), centre.y() - off.y()};
}

void PlanView::zoom(const QPointF& about, double factor) {
    const QPointF kept = metresAt(about);
    zoom_ = std::clamp(zoom_ * factor, 0.05, 1e5);
    shift_ += about - pointOf(kept.x(), kept.y());
    update();
}

void PlanView::drawGrid(QPainter& painter) const {
    const PlotStyle style = PlotStyle::screen(palette());
    const double step_m = roundAbove(70.0 / scale());
    const QPointF low = metresAt(QPointF(0, height())), high = metresAt(QPointF(width(), 0));
    const auto text = [&](double value_m) {
        return step_m >= 1000.0 ? tr("%1 km").arg(value_m / 1000.0) : tr("%1 m").arg(value_m);
    };
    const QFontMetrics metrics = painter.fontMetrics();
    for (double x = std::ceil(low.x() / step_m) * step_m; x < high.x(); x += step_m) {
        const double at = pointOf(x, 0.0).x();
        painter.setPen(style.grid);
        painter.drawLine(QPointF(at, 0), QPointF(at, height()));
        painter.setPen(style.faintText);
        painter.drawText(QPointF(at + 3, height() - 5), text(std::abs(x) < 1e-9 ? 0.0 : x));
    }
    for (double y = std::ceil(low.y() / step_m) * step_m; y < high.y(); y += step_m) {
        const double at = pointOf(0.0, y).y();
        if (at > height() - 2 * metrics.height())
            continue; // the words along the lower edge are there
        painter.setPen(style.grid);
        painter.drawLine(QPointF(0, at), QPointF(width(), at));
        painter.setPen(style.faintText);
        painter.drawText(QPointF(4, at - 3), text(std::abs(y) < 1e-9 ? 0.0 : y));
    }
    // North is up.
    const QPointF tip(width() - 18, 10);
    painter.setPen(QPen(style.text, 1.5));
    painter.drawLine(tip, tip + QPointF(0, 22));
    painter.drawLine(tip, tip + QPointF(-4, 7));
    painter.drawLine(tip, tip + QPointF(4, 7));
    painter.drawText(tip + QPointF(-metrics.horizontalAdvance("N") / 2.0, 22 + metrics.ascent()),
                     "N");
}

void PlanView::drawPath(QPainter& painter, const TrajectoryTable& table,
                        const QColor& color) const {
    QPolygonF path;
    for (const TrajectoryTable::Row& row : table.rows)
        path << pointOf(row[TrajectoryTable::x], row[TrajectoryTable::y]);
    painter.setPen(QPen(color, 1.6));
    painter.drawPolyline(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    for (const TrajectoryTable::Row& row : table.rows)
        painter.drawEllipse(pointOf(row[TrajectoryTable::x], row[TrajectoryTable::y]), 2.5, 2.5);
}

void PlanView::label(QPainter& painter, const QPointF& at, const QString& text) const {
    const QFontMetrics metrics = painter.fontMetrics();
    QPointF from = at + QPointF(10, -8);
    from.setX(std::min(from.x(), width() - metrics.horizontalAdvance(text) - 4.0));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(from, text);
}

void PlanView::drawEntity(QPainter& painter, const Place& place, const QColor& color,
                          const QString& name) const {
    const QPointF at = pointOf(place.at_m.x(), place.at_m.y());
    painter.save();
    painter.translate(at);
    painter.rotate(-irsg::degrees(place.heading_rad));
    painter.setPen(QPen(palette().color(QPalette::Base), 1.0));
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF{{0, -10}, {6, 7}, {0, 3.5}, {-6, 7}});
    painter.restore();
    label(painter, at, tr("%1, %2 m").arg(name).arg(std::round(place.altitude_m)));
}

void PlanView::drawSensor(QPainter& painter, std::size_t sensor, const QColor& color) const {
    const auto place = sensorAt(sensor);
    if (!place)
        return;
    const QPointF at = pointOf(place->at_m.x(), place->at_m.y());
    const auto towards = [&](double angle_rad, double length) {
        return at + length * QPointF(-std::sin(angle_rad), -std::cos(angle_rad));
    };
    const bool isShown = sensor == sensor_;
    const double reach = width() + height();
    if (isShown && fov_deg_ > 0.0 && fov_deg_ < 180.0) {
        const double half_rad = irsg::radians(fov_deg_) / 2.0;
        QColor faint = color;
        faint.setAlphaF(0.14F);
        painter.setPen(QPen(color, 1.0, Qt::DashLine));
        painter.setBrush(faint);
        painter.drawPolygon(QPolygonF{at, towards(place->heading_rad - half_rad, reach),
                                      towards(place->heading_rad + half_rad, reach)});
    }
    painter.setPen(QPen(color, 2.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(QRectF(at - QPointF(5, 5), QSizeF(10, 10)));
    painter.drawLine(at, towards(place->heading_rad, 15.0));
}

void PlanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!state_)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    drawGrid(painter);
    const PlotStyle style = PlotStyle::screen(palette());
    const Scenario& scenario = state_->scenario;
    const QColor sensorColor = style.text;
    // The one that is shown last, over the others.
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i)
        if (i != sensor_)
            drawSensor(painter, i, style.faintText);
    if (sensor_ < scenario.sensors.size())
        drawSensor(painter, sensor_, sensorColor);
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
        const ScenarioSensor& sensor = scenario.sensors[i];
        const TrajectoryTable* table =
            sensor.mount == MountKind::trajectory ? state_->table(sensor.trajectory) : nullptr;
        if (table != nullptr)
            drawPath(painter, *table, style.faintText);
    }
    for (std::size_t i = 0; i < scenario.entities.size(); ++i) {
        const QColor color = style.curve(static_cast<int>(i));
        const ScenarioEntity& entity = scenario.entities[i];
        const TrajectoryTable* table =
            entity.trajectory.empty() ? nullptr : state_->table(entity.trajectory);
        if (table != nullptr)
            drawPath(painter, *table, color);
    }
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
        if (const auto place = entityAt(i))
            drawEntity(painter, *place, style.curve(static_cast<int>(i)),
                       textOf(scenario.entities[i].name));
    // Sensors at one place share their words.
    std::vector<std::pair<QPointF, QString>> labels;
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
        const auto place = sensorAt(i);
        if (!place)
            continue;
        const QPointF at = pointOf(place->at_m.x(), place->at_m.y());
        const auto same = std::ranges::find_if(
            labels, [&](const auto& one) { return (one.first - at).manhattanLength() < 4.0; });
        const QString name = textOf(scenario.sensors[i].name);
        if (same == labels.end())
            labels.emplace_back(at, name);
        else
            same->second += ", " + name;
    }
    for (const auto& [at, text] : labels)
        label(painter, at + QPointF(0, 20), text);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PlanView::wheelEvent(QWheelEvent* event) {
    zoom(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
    event->accept();
}

void PlanView::mousePressEvent(QMouseEvent* event) {
    dragged_ = event->position();
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
    if (!dragged_)
        return;
    shift_ += event->position() - *dragged_;
    dragged_ = event->position();
    update();
}

void PlanView::mouseReleaseEvent(QMouseEvent*) {
    dragged_.reset();
}

void PlanView::mouseDoubleClickEvent(QMouseEvent*) {
    showAll();
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle(width() / 2.0, height() / 2.0);
    if (event->key() == Qt::Key_Plus)
        zoom(middle, 1.5);
    else if (event->key() == Qt::Key_Minus)
        zoom(middle, 1.0 / 1.5);
    else if (event->key() == Qt::Key_F)
        showAll();
    else
        QWidget::keyPressEvent(event);
}

} // namespace smat::gui

#include "moc_PlanView.cpp"
