#pragma once

#include <QStringList>

#include "gui/view/PlaceHandles.h"
#include "gui/view/SensorFrusta.h"
#include "gui/view/ViewProjection.h"
#include "gui/workbench/OrbitCamera.h"
#include "irsg/geometry/view/Pose.h"

class QPainter;

namespace smat::gui {

/// What is written and drawn over the picture of the model: the sensor's frame, the camera, axes,
/// the sun and messages.
struct ViewHud {
    ViewFrame frame;
    ViewProjection projection;
    OrbitCamera camera;              ///< the one that is looked through
    bool inspecting = false;         ///< which is not the sensor's
    QRectF inset;                    ///< the picture of the other one; null where there is none
    irsg::Vec3 reference_m;          ///< of the chosen model, in the world
    irsg::Attitude attitude;         ///< of the same
    double radius_m = 1.0;           ///< of the same
    irsg::Vec3 towardsSun;           ///< unit vector
    std::vector<ViewFrustum> frusta; ///< of the sensor; none where they are not shown
    double mostSamples = 0.0;        ///< a pixel and axis, in the finest of their windows
    bool hasProject = false, hasModel = false;
    bool viewAxes = true, modelAxes = false, sunVector = false;
    bool dark = false;                   ///< what lies below: light ink is legible
    std::optional<PlaceHandles> handles; ///< by which the chosen model is placed
    QString readout;                     ///< of what is under the mouse
    QString busy;                        ///< what is being waited for
    QStringList problem;                 ///< why there is no infrared picture

    void paint(QPainter& painter) const;
    bool operator==(const ViewHud&) const = default;
    /// Length of the model's axes, m: beyond the model, but neither a few pixels nor out of sight.
    double axisLength_m() const;
    /// Of the yellow line, m.
    double sunLength_m() const { return 1.3 * axisLength_m(); }
    /// Where the world's axes start, in the window.
    QPointF viewAxesOrigin() const;

    static constexpr double viewAxisLength_px = 34.0;

  private:
    void paintInvitation(QPainter& painter) const;
    void paintFrame(QPainter& painter) const;
    void paintInset(QPainter& painter) const;
    QRectF wordsArea() const;
    void paintViewAxes(QPainter& painter) const;
    void paintModelAxes(QPainter& painter) const;
    void paintSun(QPainter& painter) const;
    void paintFrusta(QPainter& painter) const;
    void paintWords(QPainter& painter) const;
    void paintProblem(QPainter& painter) const;
};

} // namespace smat::gui
