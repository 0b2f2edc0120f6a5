#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "python/src/OpenProjects.h"
#include "python/src/Results.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::python {

namespace {

namespace fs = std::filesystem;

Settings scenarioSettings(const py::dict& given) {
    Settings settings;
    const auto texts = py::module_::import("smat._settings")
                           .attr("texts")(given)
                           .cast<std::map<std::string, std::string>>();
    for (const auto& [key, text] : texts) {
        if (!isScenarioSetting(settingInfo(key)))
            throw badArgument(
                "settings", key,
                "a setting of sensor, scaling, environment, render, display or image: "
                "camera, target and state follow from the trajectories");
        settings.set(key, text, "settings");
    }
    return settings;
}

std::vector<std::shared_ptr<SensorResult>>
simulated(const Scenario& scenario, const fs::path& folder, const std::vector<std::string>& sensors,
          std::optional<double> from_s, std::optional<double> to_s,
          const std::vector<std::string>& extensions, const py::dict& settings,
          const py::object& progress) {
    prepareProcess();
    SimulationJob job;
    job.scenario = scenario;
    job.overrides = scenarioSettings(settings);
    job.request = {sensors, from_s, to_s};
    job.folder = folder;
    job.extensions = extensions;
    std::vector<std::shared_ptr<SensorResult>> results;
    std::vector<std::string> warnings;
    PythonProgress watch(progress);
    withoutLock([&] {
        JobRunner runner;
        const PlannedSimulation planned = runner.plan(std::move(job));
        warnings = planned.files().makeFolders(planned.plan.sensors);
        SimulationOutcome outcome =
            runner.run(planned, {.progress = watch.callback(), .stop = watch.stop()});
        for (SensorResult& sensor : outcome.result.sensors)
            results.push_back(std::make_shared<SensorResult>(std::move(sensor)));
    });
    watch.finish();
    for (const auto& sensor : results)
        for (const std::string& warning : sensor->warnings)
            warnings.push_back(sensor->name + ": " + warning);
    warnOf(warnings);
    return results;
}

} // namespace

void addScenarios(py::module_& module) {
    py::class_<SensorResult, std::shared_ptr<SensorResult>>(
        module, "SensorResult", "What one sensor of a scenario has seen.")
        .def_readonly("name", &SensorResult::name, "The name of the sensor.")
        .def_readonly("frames", &SensorResult::frames, "Frames that were made, of all bands.")
        .def_readonly("frames_missing", &SensorResult::framesMissing,
                      "Steps at which its mount or its target was not there.")
        .def_readonly("folder", &SensorResult::folder, "Where the frames are.")
        .def_readonly("warnings", &SensorResult::warnings, "What there is to warn of.")
        .def_property_readonly(
            "table",
            [](const std::shared_ptr<SensorResult>& sensor) {
                return std::shared_ptr<ResultTable>(sensor, &sensor->table);
            },
            "The Table: a row for each step, columns for each entity.");
    py::class_<Scenario>(module, "Scenario", R"(Entities that sensors see over time.

Parameters
----------
file : str or os.PathLike
    A scenario (JSON, docs/formats-scenario.md).

Raises
------
InputError
    With every key path and line that is wrong.
)")
        .def(py::init([](const fs::path& file) {
                 std::vector<std::string> remarks;
                 Scenario scenario = withoutLock([&] { return loadScenario(file, &remarks); });
                 warnOf(remarks);
                 return scenario;
             }),
             py::arg("file"))
        .def_property_readonly(
            "file", [](const Scenario& scenario) { return scenario.file; }, "Its file.")
        .def_readonly("title", &Scenario::title, "Its title.")
        .def_property_readonly(
            "times_s", [](const Scenario& scenario) { return arrayOf(scenario.times_s()); },
            "Times of the steps, s, shape (n,).")
        .def_property_readonly(
            "sensors",
            [](const Scenario& scenario) {
                std::vector<std::string> names;
                for (const ScenarioSensor& sensor : scenario.sensors)
                    names.push_back(sensor.name);
                return names;
            },
            "Names of the sensors.")
        .def_property_readonly(
            "entities",
            [](const Scenario& scenario) {
                std::vector<std::string> names;
                for (const ScenarioEntity& entity : scenario.entities)
                    names.push_back(entity.name);
                return names;
            },
            "Names of the entities.")
        .def("simulate", &simulated, py::arg("folder"), py::kw_only(),
             py::arg("sensors") = std::vector<std::string>(), py::arg("from_s") = py::none(),
             py::arg("to_s") = py::none(), py::arg("extensions") = std::vector<std::string>{".exr"},
             py::arg("settings") = py::dict(), py::arg("progress") = py::none(),
             R"(Render the frames of a scenario into a folder, as `smat-batch simulate` does.

Parameters
----------
folder : str or os.PathLike
    Gets a folder for each sensor, with its frames and its table.
sensors : list of str
    Names; empty for all.
from_s, to_s : float, optional
    First and last time, s.
extensions : list of str
    Forms of the frames.
settings : dict of str to object
    Settings of all sensors by key.
progress : callable, optional
    As that of Project.run.

Returns
-------
list of SensorResult
    In the order of the scenario.

Raises
------
InputError
    For files, names, times and settings that cannot be used.
)")
        .def("__repr__", [](const Scenario& scenario) {
            return "Scenario " + scenario.displayName() + ": " +
                   std::to_string(scenario.sensors.size()) + " sensors, " +
                   std::to_string(scenario.entities.size()) + " entities";
        });
}

} // namespace smat::python
