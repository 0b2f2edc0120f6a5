#pragma once

#include <optional>
#include <string>
#include <vector>

#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/simulate/LoadedScenario.h"

namespace smat {

/// One frame of one sensor.
struct SensorFrame {
    std::size_t sensor = 0;
    double time_s = 0.0;
    std::size_t band = 0; ///< of the sensor's bands
    irsg::Viewpoint viewpoint;
    /// By entity; no value where it is not there.
    std::vector<std::optional<TrajectoryPoint>> entities;
    std::vector<std::optional<irsg::ObjectRadiometry>> objects; ///< the same
    irsg::RenderedImage rendered;
    std::size_t saturated = 0; ///< pixels, where a sensor reads the frame
    std::vector<std::string>
        warnings; ///< end values of tables that hold, entities that are cut off
};

/// Adapts a simulation to the infrared scene generator (the report's SceneGenerator3D, F02): puts
/// the entities of a scenario where they are at a time and draws them as each of several sensors
/// sees them, all with one renderer. What a sensor sees does not depend on the others.
class SceneGenerator3D {
  public:
    /// The scenario must outlive it. Throws InputError where the renderer refuses the scene.
    SceneGenerator3D(const LoadedScenario& scenario, RenderDoor door);

    std::size_t sensorCount() const { return scenario_.sensors.size(); }
    const LoadedScenario& scenario() const { return scenario_; }
    /// False where the sensor's mount, or what it tracks, is not there: there is no frame then.
    bool sees(std::size_t sensor, double time_s) const;
    /// Throws InputError naming sensors and entities that are below the ground, and sensors that
    /// are where they look to, each with the first of these times at which they are.
    void check(const std::vector<std::size_t>& sensors, const std::vector<double>& times_s) const;
    /// A frame without its drawing, and everybody where they are as this sensor sees them.
    /// LogicError where the sensor does not see.
    std::pair<SensorFrame, PlacedCase> place(std::size_t sensor, double time_s,
                                             std::size_t band = 0) const;
    /// The same with its drawing, read by the sensor where it has one (`image.sensor`), whose sums
    /// of several bands are from the same drawings, as those of sweeps are. Throws InputError as
    /// the renderer does.
    SensorFrame frame(std::size_t sensor, double time_s, std::size_t band = 0);

  private:
    irsg::Vec3 referencePoint(std::size_t entity, const TrajectoryPoint& at) const;
    std::optional<irsg::Viewpoint> viewpoint(std::size_t sensor, double time_s) const;
    /// The picture of what was placed, with the sums of its band.
    irsg::RenderedImage render(const SensorFrame& frame, const PlacedCase& placed);
    /// The same as the sensor reads it.
    void read(SensorFrame& frame, const PlacedCase& placed);
    /// Of all bands of a sensor, as it was placed.
    const std::vector<irsg::RenderReport>& sumsOf(const SensorFrame& frame,
                                                  const PlacedCase& placed);

    const LoadedScenario& scenario_;
    RenderDoor door_;
    CasePlacer placer_;
    struct {
        std::optional<std::pair<std::size_t, double>> of; ///< sensor and time, s
        std::vector<irsg::RenderReport> byBand;
    } sums_; ///< of the moment that was asked for last
};

} // namespace smat
