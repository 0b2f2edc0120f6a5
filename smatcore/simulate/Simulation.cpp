#include "smatcore/simulate/Simulation.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include <fmt/format.h>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using irsg::Quantity;

constexpr Quantity entityQuantities[] = {Quantity::intensity, Quantity::contrastIntensity,
                                         Quantity::irradiance, Quantity::pixels};
constexpr Quantity quantitiesWithErrors[] = {Quantity::intensity, Quantity::contrastIntensity,
                                             Quantity::irradiance};

ErrorColumns errorsOf(const LoadedScenario& loaded, std::size_t sensor) {
    return errorColumnsOf(loaded.sensors[sensor].settings);
}

/// Labels of the bands of a sensor, "" of a single one.
std::vector<std::string> labelsOf(const LoadedScenario& loaded, std::size_t sensor) {
    const std::vector<irsg::Band> bands = loaded.sensors[sensor].scene.allBands();
    return bands.size() > 1 ? bandLabels(bands) : std::vector<std::string>{""};
}

SensorResult resultOf(const LoadedScenario& loaded, std::size_t sensor) {
    SensorResult result{.sensor = sensor,
                        .name = loaded.scenario.sensors[sensor].name,
                        .table = {},
                        .providedBy = {},
                        .warnings = loaded.sensors[sensor].warnings};
    irsg::appendUnique(result.warnings, loaded.sensors[sensor].scene.remarks);
    result.table.add(Quantity::time);
    result.table.add("frame", "");
    const std::vector<std::string> bands = labelsOf(loaded, sensor);
    const auto add = [&](const std::string& entity, Quantity quantity, const std::string& band,
                         const char* prefix = "") {
        const irsg::QuantityInfo& column = irsg::info(quantity);
        result.table.add(ColumnName{prefix, entity, std::string(column.key), band}.key(),
                         std::string(column.unit));
    };
    for (const std::string& band : bands)
        add("", Quantity::totalIrradiance, band);
    for (const ScenarioEntity& entity : loaded.scenario.entities) {
        add(entity.name, Quantity::range, "");
        for (const std::string& band : bands) {
            for (const Quantity quantity : entityQuantities)
                add(entity.name, quantity, band);
            for (const Quantity quantity : quantitiesWithErrors)
                for (const char* prefix : errorPrefixes(errorsOf(loaded, sensor)))
                    add(entity.name, quantity, band, prefix);
        }
    }
    return result;
}

/// What is kept of the frames of one step, one for each band.
struct StepSums {
    std::vector<double> totalIrradiance_W_m2;                           ///< by band
    std::vector<std::vector<std::optional<irsg::ObjectRadiometry>>> of; ///< by band, then by entity
};

void takeFrame(const SensorFrame& frame, StepSums& sums, CaseRecord& record,
               CaseWarnings& warnings) {
    sums.totalIrradiance_W_m2.push_back(frame.rendered.report.totalIrradiance_W_m2);
    sums.of.push_back(frame.objects);
    irsg::addProvider(record.providedBy, frame.rendered.report.providedBy);
    for (const std::string& sentence : frame.rendered.report.warnings)
        warnings.add(sentence);
    for (const std::string& sentence : frame.warnings)
        warnings.add(sentence);
    if (frame.saturated > 0)
        warnings.addWorst(
            "saturated", static_cast<double>(frame.saturated),
            fmt::format("up to {} pixels of a frame are saturated in the sensor", frame.saturated));
    if (const int left = frame.rendered.report.layersLeftOver; left > 0)
        warnings.addWorst("layers", left,
                          fmt::format("up to {} samples of a frame have more transparent layers "
                                      "than are kept, see {}",
                                      left, key::renderLayers.name));
}

std::vector<double> rowOf(const SimulationPlan::Step& step, const StepSums& sums,
                          ErrorColumns errors) {
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
                appendErrors(row, object->errors, errors);
            } else {
                row.insert(row.end(),
                           std::size(entityQuantities) +
                               std::size(quantitiesWithErrors) * errorPrefixes(errors).size(),
                           nowhere);
            }
        }
    }
    return row;
}

/// Tells what there is to warn of when the run ends, however it ends.
class Closing {
  public:
    Closing(SimulationResult& result, const std::vector<CaseWarnings>& warnings)
        : result_(result), warnings_(warnings) {}
    ~Closing() {
        for (std::size_t i = 0; i < warnings_.size(); ++i)
            irsg::appendUnique(result_.sensors[i].warnings, warnings_[i].sentences());
        result_.elapsed_s = elapsed_s();
    }
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;

    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    SimulationResult& result_;
    const std::vector<CaseWarnings>& warnings_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Tells the stores of a run in parts what their results say of themselves.
void beginSteps(const SimulationSteps& steps, const SimulationPlan& plan,
                const SimulationResult& result) {
    for (std::size_t i = 0; i < result.sensors.size(); ++i) {
        AnalysisData head;
        head.kind = AnalysisKind::simulation;
        head.name = result.sensors[i].name;
        head.table = result.sensors[i].table;
        head.table.provenance = steps.provenance(result.sensors[i]);
        steps.stores.at(i)->begin(head, plan.steps.size());
    }
}

/// What becomes of the step of a sensor, drawn or known.
void takeStep(SensorResult& sensor, const CaseRecord& record, std::size_t bands) {
    irsg::addProvider(sensor.providedBy, record.providedBy);
    if (record.row.empty()) {
        ++sensor.framesMissing;
    } else {
        sensor.table.addRow(record.row, rowWarning(record.remarks));
        sensor.frames += bands;
    }
}

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
                   StageTimer* timer, const SimulationSteps* steps) {
    generator.check(plan.sensors, plan.times_s());
    result = {.state = AnalysisState::partial, .sensors = {}, .elapsed_s = 0.0};
    for (const std::size_t sensor : plan.sensors)
        result.sensors.push_back(resultOf(generator.scenario(), sensor));
    if (steps != nullptr)
        beginSteps(*steps, plan, result);
    std::vector<CaseWarnings> warnings(plan.sensors.size(),
                                       CaseWarnings(CaseWarnings::Telling::once));
    const Closing closing(result, warnings);

    const auto storeOf = [&](std::size_t i) { return steps ? steps->stores.at(i) : nullptr; };
    std::size_t wanted = 0;
    for (std::size_t i = 0; i < plan.sensors.size(); ++i)
        wanted += steps ? storeOf(i)->expected(plan.steps.size()) : plan.steps.size();
    logInfo(fmt::format("making frames of {} sensor{} at {} steps", plan.sensors.size(),
                        plan.sensors.size() == 1 ? "" : "s", plan.steps.size()));

    const auto drawn = [&](const SimulationPlan::Step& step, std::size_t i) {
        const SensorResult& sensor = result.sensors[i];
        CaseRecord record{fmt::format("{:.6g} s", step.time_s), {}, {}, {}};
        warnings[i].beginCase(record.place);
        if (!generator.sees(sensor.sensor, step.time_s)) {
            warnings[i].addWorst("frames missing", 0.0,
                                 "no frame at {cases} of the steps: the sensor, or what it looks "
                                 "at, is not there");
        } else {
            logDebug("frame of " + sensor.name + ": " + record.place);
            StepSums sums;
            const auto& scene = generator.scenario().sensors[sensor.sensor].scene;
            for (std::size_t band = 0; band < scene.allBands().size(); ++band) {
                SensorFrame frame = [&] {
                    const StageTimer::Scope scope(timer, "frames");
                    return generator.frame(sensor.sensor, step.time_s, band);
                }();
                takeFrame(frame, sums, record, warnings[i]);
                const StageTimer::Scope scope(timer, "save");
                sink(frame, step.number);
            }
            record.row = rowOf(step, sums, errorsOf(generator.scenario(), sensor.sensor));
        }
        record.remarks = warnings[i].remarks();
        return record;
    };

    std::size_t done = 0;
    for (std::size_t number = 0; number < plan.steps.size(); ++number) {
        const SimulationPlan::Step& step = plan.steps[number];
        for (std::size_t i = 0; i < plan.sensors.size(); ++i) {
            SensorResult& sensor = result.sensors[i];
            CaseStore* const store = storeOf(i);
            const std::size_t bands =
                generator.scenario().sensors[sensor.sensor].scene.allBands().size();
            if (const CaseRecord* known = store ? store->known(number) : nullptr) {
                warnings[i].addCase(known->place, known->remarks);
                takeStep(sensor, *known, bands);
                ++done;
                continue;
            }
            if (store != nullptr && !store->isMine(number))
                continue;
            if (progress)
                progress({done, wanted, closing.elapsed_s(),
                          fmt::format("{}: {:.6g} s", sensor.name, step.time_s)});
            if (stop.stop_requested())
                return;
            const CaseRecord record = drawn(step, i);
            takeStep(sensor, record, bands);
            if (store != nullptr)
                store->add(number, record);
            ++done;
        }
    }
    if (done == plan.steps.size() * plan.sensors.size())
        result.state = AnalysisState::complete;
    if (progress)
        progress({done, wanted, closing.elapsed_s(), "frames"});
}

} // namespace smat
