#pragma once

#include <optional>

#include <QPointF>
#include <QWidget>

#include "gui/scenario/ScenarioDocument.h"

namespace smat::gui {

/// A scenario from above, north up: trajectories with a mark at each of their points, entities and
/// sensors where they are at a time, with the field of view of the sensor that is shown. The wheel
/// zooms at the cursor, a drag moves the plan, a double click shows all of it.
class PlanView : public QWidget {
    Q_OBJECT

  public:
    explicit PlanView(QWidget* parent = nullptr);

    void setScenario(std::shared_ptr<const EditedScenario> state);
    /// `fov_deg` is across the picture of the sensor that is shown.
    void setMoment(double time_s, std::size_t sensor, double fov_deg);
    void showAll();
    QSize sizeHint() const override { return {320, 240}; }
    QPointF pointOf(double east_m, double north_m) const;
    QPointF metresAt(const QPointF& point) const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    struct Place {
        QPointF at_m;
        double heading_rad = 0.0; ///< counter-clockwise from north
        double altitude_m = 0.0;
    };
    std::optional<Place> entityAt(std::size_t entity) const;
    std::optional<Place> sensorAt(std::size_t sensor) const;
    QRectF extent_m() const;
    double scale() const; ///< window pixels a metre
    void zoom(const QPointF& about, double factor);
    void drawGrid(QPainter& painter) const;
    void drawPath(QPainter& painter, const TrajectoryTable& table, const QColor& color) const;
    void drawEntity(QPainter& painter, const Place& place, const QColor& color,
                    const QString& name) const;
    void drawSensor(QPainter& painter, std::size_t sensor, const QColor& color) const;
    void label(QPainter& painter, const QPointF& at, const QString& text) const;

    std::shared_ptr<const EditedScenario> state_;
    LoadedScenario paths_; ///< places alone: nothing of it is loaded
    double time_s_ = 0.0, fov_deg_ = 0.0;
    std::size_t sensor_ = 0;
    double zoom_ = 1.0;
    QPointF shift_;
    std::optional<QPointF> dragged_;
};

} // namespace smat::gui
