#include "smatcore/simulate/SceneGenerator3D.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/NewLines.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/ErrorColumns.h"

namespace smat {

namespace {

/// As far below the ground as rounding may put what stands on it.
constexpr double groundRounding_m = 1e-6;
/// A sensor closer than this to what it tracks has no direction to look along.
constexpr double nearest_m = 1e-3;

} // namespace

SceneGenerator3D::SceneGenerator3D(const LoadedScenario& scenario, ImageSource& source)
    : scenario_(scenario), source_(source), isThere_(scenario.paths.size(), true) {
    source_.configure(scenario_.sensors.front().scene);
    selected_ = {0, 0};
    for (std::size_t i = 0; i < scenario_.paths.size(); ++i)
        referencePoints_.push_back(source_.referencePointInModel(i));
}

irsg::Vec3 SceneGenerator3D::referencePoint(std::size_t entity, const TrajectoryPoint& at) const {
    return at.pose.toWorld(referencePoints_[entity]);
}

std::optional<irsg::Viewpoint> SceneGenerator3D::viewpoint(std::size_t sensor,
                                                           double time_s) const {
    const std::optional<SensorPlace> place = scenario_.sensorAt(sensor, time_s);
    if (!place)
        return std::nullopt;
    const std::string& tracked = scenario_.scenario.sensors[sensor].track;
    if (tracked.empty()) {
        return irsg::Viewpoint{.position_m = place->position_m,
                               .right = place->axes * irsg::Vec3{1, 0, 0},
                               .up = place->axes * irsg::Vec3{0, 0, 1},
                               .backward = place->axes * irsg::Vec3{0, -1, 0}};
    }
    const std::size_t entity = scenario_.scenario.findEntity(tracked).value();
    const std::optional<TrajectoryPoint> target = scenario_.entityAt(entity, time_s);
    if (!target)
        return std::nullopt;
    const irsg::Vec3 point = referencePoint(entity, *target);
    // Too close to have a direction; check says so before anything is drawn.
    if (irsg::length(point - place->position_m) < nearest_m)
        return irsg::Viewpoint{.position_m = place->position_m};
    return irsg::Viewpoint::lookAt(place->position_m, point);
}

bool SceneGenerator3D::sees(std::size_t sensor, double time_s) const {
    return viewpoint(sensor, time_s).has_value();
}

void SceneGenerator3D::check(const std::vector<std::size_t>& sensors,
                             const std::vector<double>& times_s) const {
    std::vector<irsg::Diagnostic> diagnostics;
    std::set<std::string> named;
    const auto refuse = [&](const std::string& what, double time_s, const std::string& value,
                            const std::string& expected) {
        if (named.insert(what + expected).second) {
            diagnostics.push_back({.file = scenario_.scenario.displayName(),
                                   .position = fmt::format("{} at {} s", what, time_s),
                                   .value = value,
                                   .expected = expected});
        }
    };
    const auto refuseBelowGround = [&](const std::string& what, double time_s, double altitude_m) {
        if (altitude_m < -groundRounding_m) {
            refuse(what, time_s, fmt::format("an altitude of {:.6g} m", altitude_m),
                   "at least 0 m");
        }
    };
    for (const double time_s : times_s) {
        for (std::size_t i = 0; i < scenario_.paths.size(); ++i) {
            if (const auto at = scenario_.entityAt(i, time_s)) {
                refuseBelowGround("reference point of " + scenario_.scenario.entities[i].name,
                                  time_s, referencePoint(i, *at).z);
            }
        }
        for (const std::size_t sensor : sensors) {
            const ScenarioSensor& given = scenario_.scenario.sensors[sensor];
            const std::optional<irsg::Viewpoint> view = viewpoint(sensor, time_s);
            if (!view)
                continue;
            refuseBelowGround("sensor " + given.name, time_s, view->position_m.z);
            if (!given.track.empty()) {
                const std::size_t entity = scenario_.scenario.findEntity(given.track).value();
                const double range_m = irsg::length(
                    referencePoint(entity, *scenario_.entityAt(entity, time_s)) - view->position_m);
                if (range_m < nearest_m) {
                    refuse("sensor " + given.name, time_s,
                           fmt::format("{:.3g} m to {}, which it tracks", range_m, given.track),
                           fmt::format("at least {} m", nearest_m));
                }
            }
        }
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

void SceneGenerator3D::select(std::size_t sensor, std::size_t band,
                              const std::vector<bool>& isThere) {
    if (selected_ == std::pair(sensor, band) && isThere == isThere_)
        return;
    SceneDescription scene = scenario_.sensors.at(sensor).scene;
    scene.sensor.band = scene.allBands().at(band);
    for (std::size_t i = isThere.size(); i-- > 0;)
        if (!isThere[i])
            scene.entities.erase(scene.entities.begin() + static_cast<std::ptrdiff_t>(i));
    if (isThere == isThere_)
        source_.setView(scene);
    else
        source_.configure(scene);
    isThere_ = isThere;
    selected_ = {sensor, band};
}

SensorFrame SceneGenerator3D::place(std::size_t sensor, double time_s, std::size_t band) {
    SensorFrame frame;
    frame.sensor = sensor;
    frame.band = band;
    frame.time_s = time_s;
    const std::optional<irsg::Viewpoint> view = viewpoint(sensor, time_s);
    if (!view)
        throw irsg::LogicError("a frame was asked for at a time at which the sensor is not there");
    frame.viewpoint = *view;
    std::vector<bool> isThere;
    for (std::size_t i = 0; i < scenario_.paths.size(); ++i) {
        frame.entities.push_back(scenario_.entityAt(i, time_s));
        isThere.push_back(frame.entities.back().has_value());
    }
    select(sensor, band, isThere);

    // Everybody to where they are now.
    const std::vector<irsg::Entity>& entities = scenario_.sensors[sensor].scene.entities;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (!frame.entities[i])
            continue;
        const TrajectoryPoint& at = *frame.entities[i];
        irsg::EntityState state = entities[i].state;
        state.time_s = time_s + scenario_.scenario.entities[i].timeOffset_s;
        state.power = at.power;
        state.mach = at.mach;
        source_.setPose(drawn, at.pose);
        source_.setState(drawn, state);
        ++drawn;
        const std::vector<std::string> held = clampedTableWarnings(
            entities[i], state, at.pose, referencePoint(i, at), view->position_m);
        frame.warnings.insert(frame.warnings.end(), held.begin(), held.end());
    }
    source_.setViewpoint(*view);
    return frame;
}

const std::vector<irsg::RenderReport>& SceneGenerator3D::sumsOf(const SensorFrame& placed) {
    const std::pair moment(placed.sensor, placed.time_s);
    if (sums_.of == moment)
        return sums_.byBand;
    sums_.of.reset();
    const LoadedSensor& sensor = scenario_.sensors[placed.sensor];
    const bool withErrors = errorColumnsOf(sensor.settings) != ErrorColumns::none;
    sums_.byBand = source_.beginMeasure({sensor.scene.allBands(), false, false, withErrors})();
    sums_.of = moment;
    return sums_.byBand;
}

irsg::RenderedImage SceneGenerator3D::render(const SensorFrame& placed) {
    const LoadedSensor& sensor = scenario_.sensors[placed.sensor];
    if (sensor.scene.allBands().size() == 1)
        return errorColumnsOf(sensor.settings) == ErrorColumns::none ? source_.render()
                                                                     : source_.renderWithErrors();
    irsg::RenderReport sums = sumsOf(placed).at(placed.band);
    irsg::RenderedImage rendered = source_.renderImage();
    sums.windows = std::move(rendered.report.windows);
    irsg::addNew(sums.warnings, rendered.report.warnings);
    sums.layersLeftOver = rendered.report.layersLeftOver;
    rendered.report = std::move(sums);
    return rendered;
}

SensorFrame SceneGenerator3D::frame(std::size_t sensor, double time_s, std::size_t band) {
    SensorFrame frame = place(sensor, time_s, band);
    frame.rendered = render(frame);
    if (const auto& errors = frame.rendered.report.all.errors)
        describeErrors(*errors, frame.rendered.image);

    // Back from those that were drawn to all of them.
    std::size_t drawn = 0;
    for (const auto& at : frame.entities) {
        frame.objects.push_back(at ? std::optional(frame.rendered.report.objects.at(drawn++))
                                   : std::nullopt);
    }
    return frame;
}

} // namespace smat
