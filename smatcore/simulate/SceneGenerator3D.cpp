#include "smatcore/simulate/SceneGenerator3D.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/ImageSensor.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// As far below the ground as rounding may put what stands on it.
constexpr double groundRounding_m = 1e-6;
/// A sensor closer than this to what it tracks has no direction to look along.
constexpr double nearest_m = 1e-3;

} // namespace

SceneGenerator3D::SceneGenerator3D(const LoadedScenario& scenario, RenderDoor door)
    : scenario_(scenario),
      door_(std::move(door)),
      placer_(door_, scenario_.sensors.front().scene) {}

irsg::Vec3 SceneGenerator3D::referencePoint(std::size_t entity, const TrajectoryPoint& at) const {
    return at.pose.toWorld(placer_.referencePoints()[entity]);
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

std::pair<SensorFrame, PlacedCase> SceneGenerator3D::place(std::size_t sensor, double time_s,
                                                           std::size_t band) const {
    SensorFrame frame;
    frame.sensor = sensor;
    frame.band = band;
    frame.time_s = time_s;
    const std::optional<irsg::Viewpoint> view = viewpoint(sensor, time_s);
    if (!view)
        throw irsg::LogicError("a frame was asked for at a time at which the sensor is not there");
    frame.viewpoint = *view;

    const SceneDescription& scene = scenario_.sensors.at(sensor).scene;
    std::vector<std::optional<EntityPlace>> places;
    for (std::size_t i = 0; i < scenario_.paths.size(); ++i) {
        const std::optional<TrajectoryPoint>& at =
            frame.entities.emplace_back(scenario_.entityAt(i, time_s));
        if (!at) {
            places.emplace_back();
            continue;
        }
        irsg::EntityState state = scene.entities[i].state;
        state.time_s = time_s + scenario_.scenario.entities[i].timeOffset_s;
        state.power = at->power;
        state.mach = at->mach;
        places.emplace_back(EntityPlace{at->pose, state});
    }
    PlacedCase placed = placer_.place(scene, places, *view);
    placed.view.sensor.band = scene.allBands().at(band);
    frame.warnings = placed.clampedTables();
    return {std::move(frame), std::move(placed)};
}

const std::vector<irsg::RenderReport>& SceneGenerator3D::sumsOf(const SensorFrame& frame,
                                                                const PlacedCase& placed) {
    const std::pair moment(frame.sensor, frame.time_s);
    if (sums_.of == moment)
        return sums_.byBand;
    sums_.of.reset();
    const LoadedSensor& sensor = scenario_.sensors[frame.sensor];
    const bool withErrors = errorColumnsOf(sensor.settings) != ErrorColumns::none;
    sums_.byBand =
        placed.render(door_, irsg::Outputs::reports(sensor.scene.allBands()).withErrors(withErrors))
            .reports;
    sums_.of = moment;
    return sums_.byBand;
}

irsg::RenderedImage SceneGenerator3D::render(const SensorFrame& frame, const PlacedCase& placed) {
    const LoadedSensor& sensor = scenario_.sensors[frame.sensor];
    const bool isAlone = sensor.scene.moreBands.empty();
    const bool withErrors = errorColumnsOf(sensor.settings) != ErrorColumns::none;
    std::optional<irsg::RenderReport> sums;
    if (!isAlone)
        sums = sumsOf(frame, placed).at(frame.band);
    irsg::Rendered rendered =
        placed.render(door_, isAlone ? irsg::Outputs::imageWithReports().withErrors(withErrors)
                                     : irsg::Outputs::image());
    irsg::RenderReport& drawn = rendered.reports.front();
    if (!sums)
        return {std::move(rendered.image), std::move(drawn)};
    sums->tiles = std::move(drawn.tiles);
    irsg::appendUnique(sums->warnings, drawn.warnings);
    sums->layersLeftOver = drawn.layersLeftOver;
    return {std::move(rendered.image), std::move(*sums)};
}

void SceneGenerator3D::read(SensorFrame& frame, const PlacedCase& placed) {
    const LoadedSensor& sensor = scenario_.sensors[frame.sensor];
    frame.rendered.report = sumsOf(frame, placed).front();
    const double steps =
        std::round((frame.time_s - scenario_.scenario.start_s) / scenario_.scenario.dt_s);
    // Sensors of one seed have noise of their own.
    const FrameNoise noise{.seed =
                               static_cast<std::uint64_t>(sensor.settings[key::imageNoiseSeed]) |
                               std::uint64_t{frame.sensor} << 32,
                           .frame = static_cast<std::uint32_t>(std::max(0.0, steps))};
    const irsg::SensorReading reading = drawThroughSensor(frame.rendered.image, *sensor.chain,
                                                          sensor.settings, placed, door_, noise);
    frame.saturated = reading.saturated;
}

SensorFrame SceneGenerator3D::frame(std::size_t sensor, double time_s, std::size_t band) {
    auto [frame, placed] = place(sensor, time_s, band);
    if (scenario_.sensors.at(sensor).chain)
        read(frame, placed);
    else
        frame.rendered = render(frame, placed);
    if (const auto& errors = frame.rendered.report.all.errors)
        describeErrors(*errors, frame.rendered.image);

    // Back from those that were drawn to all of them.
    std::size_t drawn = 0;
    for (const auto& at : frame.entities) {
        if (!at) {
            frame.objects.push_back(std::nullopt);
            continue;
        }
        const irsg::Entity& entity = placed.scene.entities.at(drawn);
        frame.objects.push_back(frame.rendered.report.objects.at(drawn++));
        // One that the sensor does not look at has sums of 0, which nobody takes for its own.
        if (frame.objects.back()->coveredPixels > 0.0 &&
            reachesBeyondFrame(entity, entity.pose, placed.view.viewpoint, placed.view.sensor))
            frame.warnings.push_back(beyondFrameWarning(entity.name));
    }
    return std::move(frame);
}

} // namespace smat
