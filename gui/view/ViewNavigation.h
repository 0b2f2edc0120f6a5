#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QPointF>
#include <QRectF>

#include "gui/view/ViewCameras.h"
#include "gui/view/ViewProjection.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace smat::gui {

/// Moves the cameras of a view, by its mouse and keys or as it is told: see SceneView for what does
/// what. Clicks that move nothing, and where the mouse reads, are told.
class ViewNavigation : public QObject {
    Q_OBJECT

  public:
    /// What of the view a movement goes by.
    struct Surroundings {
        ViewProjection projection;
        ViewFrame frame;
        double radius_m = 1.0; ///< of the target
        double reach_m = 1.0;  ///< of all models about it
        ViewBall all, chosen;  ///< models, counted from the target's reference point
        QRectF inset;          ///< of the other camera's picture; null where there is none
    };
    ViewNavigation(QWidget* view, std::function<Surroundings()> surroundings);

    const ViewCameras& cameras() const { return cameras_; }
    void setSensor(const OrbitCamera& camera) { cameras_.setSensor(camera); }
    /// Those of another view, as if they had been moved here.
    void take(const ViewCameras& cameras);
    /// Back to the sensor alone.
    void forgetInspection();
    void showCamera(ViewCamera camera);
    /// Of the inspection camera: all models, the chosen one, or a side.
    void fit();
    void fitChosen();
    void lookAt(ViewSide side);
    /// Moves the sensor, which looks at the target, to where that is seen as a whole, or all
    /// models.
    void showWholeModel();
    void showWholeScene();
    bool isDragging() const { return dragFrom_.has_value(); }
    /// Where the mouse reads the picture: nowhere outside of it and during a drag.
    std::optional<QPointF> readsAt() const { return dragFrom_ ? std::nullopt : hoverAt_; }

  signals:
    /// Another camera is looked through, or the same from another place.
    void moved();
    /// The other camera is looked through than when this was told last.
    void cameraChanged();
    /// It was the sensor that moved.
    void sensorMoved(const OrbitCamera& camera);
    void clicked(const QPointF& point, Qt::KeyboardModifiers modifiers);
    /// readsAt() may be another place.
    void hovered();
    /// Escape.
    void dismissed();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void turnWheel(const QWheelEvent& event);
    bool pressKey(const QKeyEvent& event);
    void hover(const std::optional<QPointF>& point);
    OrbitCamera& camera(bool sensor);
    void moveSensorBack(double radius_m);
    void tellMoved(bool sensor);
    void tellCamera();

    std::function<Surroundings()> surroundings_;
    ViewCameras cameras_;
    ViewCamera told_ = ViewCamera::sensor; ///< as the last cameraChanged had it
    std::optional<QPointF> pressAt_, dragFrom_, hoverAt_;
    bool dragsSensor_ = false, dragPans_ = false;
};

} // namespace smat::gui
