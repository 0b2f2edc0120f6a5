#pragma once

#include <memory>
#include <optional>

#include <QOpenGLWidget>

#include "gui/view/DisplayScene.h"
#include "gui/view/OrbitCamera.h"

namespace smat::gui {

/// What the sensor sees, for the frame of the view.
struct ViewFrame {
    double horizontalFieldOfView_rad = 0.035;
    int width_px = 640, height_px = 512;
};

/// OpenSceneGraph in a Qt window: turns a model in its visible colours about its reference point.
/// Draws when asked and not otherwise. The left button turns, the wheel changes the range, a double
/// click shows the whole model. The picture is what the sensor sees, framed.
class SceneView : public QOpenGLWidget {
    Q_OBJECT

  public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Why this desktop cannot give a 3-D view; empty where it can.
    static QString problem();

    void setScene(DisplayScene scene);
    void setTargetPose(const irsg::Pose& pose);
    void setCamera(const OrbitCamera& camera, double targetYaw_rad);
    const OrbitCamera& camera() const { return camera_; }
    void setFrame(const ViewFrame& frame);
    void setWireframe(bool on);
    void setAxesVisible(bool on);
    /// Moves the camera to where the whole model is seen.
    void showWholeModel();
    /// GL renderer of this view; empty before its first frame.
    QString renderer() const { return renderer_; }
    /// Frames drawn so far.
    long frameCount() const { return frameCount_; }

  signals:
    /// The user moved it.
    void cameraMoved(const OrbitCamera& camera);

  protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void releaseGl();
    void aim();
    void userMoved();
    void redraw();
    void paintHud(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    QRectF frameRect() const;

    struct Parts;
    std::unique_ptr<Parts> parts_;
    OrbitCamera camera_;
    double targetYaw_rad_ = 0.0;
    ViewFrame frame_;
    bool axesVisible_ = true;
    std::optional<QPointF> dragFrom_;
    QString renderer_;
    long frameCount_ = 0;
    QWidget* hud_ = nullptr;
};

} // namespace smat::gui
