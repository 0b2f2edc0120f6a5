#include "smatcore/simulate/Simulation.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include <fmt/format.h>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/NewLines.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using irsg::Quantity;

constexpr Quantity entityQuantities[] = {Quantity::intensity, Quantity::contrastIntensity,
                                         Quantity::irradiance, Quantity::pixels};

/// Labels of the bands of a sensor, "" of a single one.
std::vector<std::string> labelsOf(const LoadedScenario& loaded, std::size_t sensor) {
    const std::vector<irsg::Band> bands = loaded.sensors[sensor].scene.allBands();
    return bands.size() > 1 ? bandLabels(bands) : std::vector<std::string>{""};
}

SensorResult resultOf(const LoadedScenario& loaded, std::size_t sensor) {
    SensorResult result{.sensor = sensor,
                        .name = loaded.scenario.sensors[sensor].name,
                        .table = {},
                        .answeredBy = {},
                        .warnings = loaded.sensors[sensor].warnings};
    irsg::addNew(result.warnings, loaded.sensors[sensor].scene.remarks);
    result.table.add(Quantity::time);
    result.table.add("frame", "");
    const std::vector<std::string> bands = labelsOf(loaded, sensor);
    const auto add = [&](const std::string& entity, Quantity quantity, const std::string& band) {
        const irsg::QuantityInfo& column = irsg::info(quantity);
        result.table.add(ColumnName{"", entity, std::string(column.key), band}.key(),
                         std::string(column.unit));
    };
    for (const std::string& band : bands)
        add("", Quantity::totalIrradiance, band);
    for (const ScenarioEntity& entity : loaded.scenario.entities) {
        add(entity.name, Quantity::range, "");
        for (const std::string& band : bands)
            for (const Quantity quantity : entityQuantities)
                add(entity.name, quantity, band);
    }
    return result;
}

/// What renderings of one sensor could not do exactly: the worst of all frames, said once.
struct Shortcomings {
    int layersLeftOver = 0;

    void take(const irsg::RenderReport& report) {
        layersLeftOver = std::max(layersLeftOver, report.layersLeftOver);
    }
    void sayIn(SensorResult& result) const {
        if (result.framesMissing > 0) {
            result.warnings.push_back(fmt::format("no frame at {} of the steps: the sensor, or "
                                                  "what it looks at, is not there",
                                                  result.framesMissing));
        }
        if (layersLeftOver > 0) {
            result.warnings.push_back(fmt::format(
                "up to {} samples of a frame have more transparent layers than are kept, see {}",
                layersLeftOver, key::renderLayers.name));
        }
    }
};

/// What is kept of the frames of one step, one for each band.
struct StepSums {
    std::vector<double> totalIrradiance_W_m2;                           ///< by band
    std::vector<std::vector<std::optional<irsg::ObjectRadiometry>>> of; ///< by band, then by entity
};

void takeFrame(SensorResult& result, const SensorFrame& frame, StepSums& sums) {
    sums.totalIrradiance_W_m2.push_back(frame.rendered.report.totalIrradiance_W_m2);
    sums.of.push_back(frame.objects);
    ++result.frames;
    irsg::addNew(result.answeredBy, frame.rendered.report.answeredBy);
    irsg::addNew(result.warnings, frame.rendered.report.warnings);
    irsg::addNew(result.warnings, frame.warnings);
}

void addRow(SensorResult& result, const SimulationPlan::Step& step, const StepSums& sums) {
    std::vector<double> row = {step.time_s, static_cast<double>(step.number)};
    row.insert(row.end(), sums.totalIrradiance_W_m2.begin(), sums.totalIrradiance_W_m2.end());
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t entity = 0; entity < sums.of.front().size(); ++entity) {
        const auto& first = sums.of.front()[entity];
        row.push_back(first ? first->range_m : nowhere);
        for (const auto& ofBand : sums.of) {
            if (const auto& object = ofBand[entity]) {
                row.insert(row.end(), {object->intensity_W_sr, object->contrastIntensity_W_sr,
                                       object->irradiance_W_m2, object->coveredPixels});
            } else {
                row.insert(row.end(), std::size(entityQuantities), nowhere);
            }
        }
    }
    result.table.addRow(row);
}

/// Tells what is missing when the run ends, however it ends.
class Closing {
  public:
    Closing(SimulationResult& result, const std::vector<Shortcomings>& shortcomings)
        : result_(result), shortcomings_(shortcomings) {}
    ~Closing() {
        for (std::size_t i = 0; i < shortcomings_.size(); ++i)
            shortcomings_[i].sayIn(result_.sensors[i]);
        result_.elapsed_s = elapsed_s();
    }
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;

    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    SimulationResult& result_;
    const std::vector<Shortcomings>& shortcomings_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

std::vector<double> SimulationPlan::times_s() const {
    std::vector<double> times;
    for (const Step& step : steps)
        times.push_back(step.time_s);
    return times;
}

SimulationPlan planSimulation(const Scenario& scenario, const SimulationRequest& request) {
    SimulationPlan plan;
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& name : request.sensors) {
        if (!scenario.findSensor(name)) {
            std::string known;
            for (const ScenarioSensor& sensor : scenario.sensors)
                known += (known.empty() ? "" : ", ") + sensor.name;
            diagnostics.push_back({.file = scenario.displayName(),
                                   .position = "sensors",
                                   .value = name,
                                   .expected = "the name of a sensor: " + known});
        }
    }
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
        if (request.sensors.empty() ||
            std::find(request.sensors.begin(), request.sensors.end(), scenario.sensors[i].name) !=
                request.sensors.end()) {
            plan.sensors.push_back(i);
        }
    }

    // A step that lies on a limit but for rounding is wanted.
    const double rounding_s = 1e-5 * scenario.dt_s;
    const std::vector<double> times_s = scenario.times_s();
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        if (times_s[i] >= request.from_s.value_or(times_s[i]) - rounding_s &&
            times_s[i] <= request.to_s.value_or(times_s[i]) + rounding_s) {
            plan.steps.push_back({i, times_s[i]});
        }
    }
    if (plan.steps.empty()) {
        diagnostics.push_back(
            {.file = scenario.displayName(),
             .position = "steps",
             .value = fmt::format("none from {} to {} s", request.from_s.value_or(times_s.front()),
                                  request.to_s.value_or(times_s.back())),
             .expected = fmt::format("times within {} to {} s, every {} s", times_s.front(),
                                     times_s.back(), scenario.dt_s)});
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return plan;
}

void runSimulation(SceneGenerator3D& generator, const SimulationPlan& plan, const FrameSink& sink,
                   SimulationResult& result, const ProgressCallback& progress, std::stop_token stop,
                   StageTimer* timer) {
    generator.check(plan.sensors, plan.times_s());
    result = {.state = AnalysisState::partial, .sensors = {}, .elapsed_s = 0.0};
    for (const std::size_t sensor : plan.sensors)
        result.sensors.push_back(resultOf(generator.scenario(), sensor));
    std::vector<Shortcomings> shortcomings(plan.sensors.size());
    const Closing closing(result, shortcomings);

    const std::size_t total = plan.steps.size() * plan.sensors.size();
    logInfo(fmt::format("making frames of {} sensor{} at {} steps", plan.sensors.size(),
                        plan.sensors.size() == 1 ? "" : "s", plan.steps.size()));
    std::size_t done = 0;
    for (const SimulationPlan::Step& step : plan.steps) {
        for (std::size_t i = 0; i < plan.sensors.size(); ++i) {
            SensorResult& sensor = result.sensors[i];
            const std::string what = fmt::format("{}: {:.6g} s", sensor.name, step.time_s);
            if (progress)
                progress({done, total, closing.elapsed_s(), what});
            if (stop.stop_requested())
                return;
            if (!generator.sees(sensor.sensor, step.time_s)) {
                ++sensor.framesMissing;
            } else {
                logDebug("frame of " + what);
                const auto& scene = generator.scenario().sensors[sensor.sensor].scene;
                StepSums sums;
                for (std::size_t band = 0; band < scene.allBands().size(); ++band) {
                    SensorFrame frame = [&] {
                        const StageTimer::Scope scope(timer, "frames");
                        return generator.frame(sensor.sensor, step.time_s, band);
                    }();
                    shortcomings[i].take(frame.rendered.report);
                    takeFrame(sensor, frame, sums);
                    const StageTimer::Scope scope(timer, "save");
                    sink(frame, step.number);
                }
                addRow(sensor, step, sums);
            }
            ++done;
        }
    }
    result.state = AnalysisState::complete;
    if (progress)
        progress({done, total, closing.elapsed_s(), "frames"});
}

} // namespace smat
