#pragma once

#include <optional>

#include "gui/view/ViewProjection.h"
#include "gui/workbench/OrbitCamera.h"

namespace smat::gui {

/// Which of the two cameras the view looks through.
enum class ViewCamera {
    sensor,    ///< that of the project: what is measured
    inspection ///< of this window alone: looking around changes nothing
};

/// A side that the inspection camera looks at.
enum class ViewSide { front, rear, port, starboard, top, bottom };

/// The sensor of the project and the inspection camera, which starts where the sensor stands.
class ViewCameras {
  public:
    ViewCamera shown() const { return shown_; }
    bool isInspecting() const { return shown_ == ViewCamera::inspection; }
    const OrbitCamera& camera() const { return isInspecting() ? *inspection_ : sensor_; }
    /// The one that is not looked through; none before anybody has looked around.
    std::optional<OrbitCamera> other() const;
    const OrbitCamera& sensor() const { return sensor_; }

    /// Looks through the sensor. It may be moved then.
    OrbitCamera& useSensor();
    /// Looks through the inspection camera, from where the view stands now. It may be moved then.
    OrbitCamera& inspect();
    void show(ViewCamera camera);
    void setSensor(const OrbitCamera& camera) { sensor_ = camera; }
    /// Back to the sensor alone, as at first.
    void forgetInspection();

    /// Moves the inspection camera until the ball, whose centre is counted from the reference
    /// point here, fills the view.
    void fit(const ViewBall& ball, double fieldOfView_rad);
    void lookAt(ViewSide side);
    /// Moves the inspection camera sideways by a part of the window, as if the model were taken
    /// along: right and down are positive.
    void pan(double right_px, double down_px, const ViewProjection& through);

    bool operator==(const ViewCameras&) const = default;

  private:
    OrbitCamera sensor_;
    std::optional<OrbitCamera> inspection_;
    ViewCamera shown_ = ViewCamera::sensor;
};

} // namespace smat::gui
