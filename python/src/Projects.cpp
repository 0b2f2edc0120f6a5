#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/FreedMemory.h"
#include "python/src/OpenProjects.h"
#include "python/src/Results.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/ImageSensor.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/support/NearestNames.h"

namespace smat::python {

namespace {

namespace fs = std::filesystem;
using Database = std::shared_ptr<irsg::SignatureDatabase>;
using Texts = std::map<std::string, std::string>;

OpenProject opened(const fs::path& file, const fs::path& database) {
    if (file.extension() != ".smat")
        return {.project = projectOfModel(file, database)};
    if (!database.empty())
        throw badArgument("database", database.string(), "no database: a project names its own");
    std::vector<std::string> remarks;
    OpenProject open{.project = withoutLock([&] { return loadProject(file, &remarks); })};
    for (const std::string& key : unknownKeys(open.project))
        remarks.push_back(file.string() + ": the key " + key +
                          " is not known to this version and has no effect" + knownKeysLike(key));
    warnOf(remarks);
    return open;
}

void setOne(OpenProject& open, const std::string& key, const std::string& text) {
    if (isModelAssignment(key))
        assignToModel(open.project, key + "=" + text);
    else
        open.overrides.set(key, text, "settings");
}

void setAll(OpenProject& open, const Texts& texts) {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const auto& [key, text] : texts) {
        try {
            setOne(open, key, text);
        } catch (const irsg::InputError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
        }
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

std::size_t modelOf(const OpenProject& open, const std::string& model) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < open.project.models.size(); ++i) {
        names.push_back(open.project.models[i].shownName());
        if (model.empty() || names.back() == model)
            return i;
    }
    throw badArgument("model", model, oneOf(names, model));
}

std::vector<std::shared_ptr<AnalysisData>>
runAnalyses(const OpenProject& open, const std::string& kind, const std::string& analysis,
            const Texts& given, const py::object& progress) {
    prepareProcess();
    std::vector<std::shared_ptr<AnalysisData>> results;
    PythonProgress watch(progress);
    withoutLock([&] {
        Job job;
        job.data = analysisOf(open, kind, analysis);
        Settings beside;
        for (const auto& [key, text] : given)
            beside.set(key, text);
        refuseIdleOfSensor(job.data, beside);
        std::vector<PlannedJob> jobs = planJobs({job});
        const Pool<JobRunner>::Lease runner(*open.runners);
        runner->scenes().setDatabaseOverrides(open.databases);
        for (PlannedJob& job : jobs) {
            runner->run(job, {.progress = watch.callback(), .stop = watch.stop()});
            results.push_back(std::make_shared<AnalysisData>(std::move(job.data)));
            if (watch.stop().stop_requested())
                break;
        }
    });
    watch.finish();
    for (const auto& result : results)
        warnOf(result->warnings);
    return results;
}

/// The scene and the view that an image of the project's own settings has.
std::pair<irsg::Scene, irsg::SensorView> sceneViewOf(const OpenProject& open) {
    return withoutLock([&] {
        const Pool<JobRunner>::Lease runner(*open.runners);
        runner->scenes().setDatabaseOverrides(open.databases);
        const SceneDescription scene = runner->scenes().build(open.project, open.inEffect());
        PlacedCase placed =
            CasePlacer(runner->door(), scene).place(scene, startingCase(open.inEffect()));
        return std::pair(std::move(placed.scene), std::move(placed.view));
    });
}

void addSettings(py::module_& module) {
    py::class_<SettingInfo>(module, "SettingInfo", "What is known of a setting.")
        .def_readonly("key", &SettingInfo::key, "'camera.range'.")
        .def_readonly("label", &SettingInfo::label, "'Range'.")
        .def_readonly("unit", &SettingInfo::unit, "'m'; '' without one.")
        .def_readonly("default", &SettingInfo::defaultText, "Its default as text.")
        .def_readonly("choices", &SettingInfo::choices, "Words that it may have.")
        .def_readonly("help", &SettingInfo::help, "What it does.")
        .def_property_readonly("expected", &SettingInfo::expected,
                               "'a number from 1 to 16384 (px)'.")
        .def_property_readonly(
            "option",
            [](const SettingInfo& info) {
                std::string word = info.option.substr(info.option.find_first_not_of('-'));
                std::ranges::replace(word, '-', '_');
                return word;
            },
            "The keyword argument of analyses, 'range' of the option --range.")
        .def_property_readonly(
            "kind",
            [](const SettingInfo& info) {
                static const std::map<SettingKind, std::string> names = {
                    {SettingKind::real, "real"},
                    {SettingKind::integer, "integer"},
                    {SettingKind::boolean, "boolean"},
                    {SettingKind::choice, "choice"},
                    {SettingKind::choiceOrReal, "choice or real"},
                    {SettingKind::realList, "real list"},
                    {SettingKind::band, "band"},
                    {SettingKind::path, "path"},
                    {SettingKind::pathList, "path list"}};
                return names.at(info.kind);
            },
            "'real', 'integer', 'boolean', 'choice', 'choice or real', 'real list', 'band', 'path' "
            "or 'path list'.")
        .def(
            "concerns",
            [](const SettingInfo& info, const std::string& kind) { return concerns(info, kind); },
            py::arg("kind"), "Whether it has an effect on an analysis of that kind.")
        .def("__repr__", [](const SettingInfo& info) { return info.key + ": " + info.expected(); });
    module.def(
        "settings", [] { return settingTable(); },
        "All settings that there are, in the order of forms: a list of SettingInfo.");
    module.def(
        "find_setting",
        [](const std::string& key) {
            const SettingInfo* info = findSetting(key);
            if (info == nullptr)
                throw badArgument("settings", key, expectedSetting(key));
            return *info;
        },
        py::arg("key"), "The SettingInfo of a key; InputError with the nearest names for another.");
    module.def("analysis_kinds", &analysisKindWords, "'image', 'spectrum', 'polar', ...");
    module.def(
        "is_no_atmosphere", [](const std::string& word) { return isNoAtmosphere(word); },
        py::arg("word"), "Whether a word means that there is no atmosphere.");
}

} // namespace

AnalysisData analysisOf(const OpenProject& open, const std::string& kind,
                        const std::string& analysis) {
    AnalysisData data;
    if (!analysis.empty()) {
        data = AnalysisData::of(open.project, analysis);
        if (!kind.empty() && name(data.kind) != kind)
            throw badArgument("analysis", analysis + ", which is of kind " + name(data.kind),
                              "an analysis of kind " + kind);
    } else {
        const std::optional<AnalysisKind> known = analysisKindFromName(kind);
        if (!known)
            throw badArgument("kind", kind, oneOf(analysisKindWords(), kind));
        data = AnalysisData::of(open.project, *known);
    }
    data.settings = data.settings.with(open.overrides);
    data.commandLine = data.equivalentCommand(name(data.kind) + resultExtensions(data.kind)[0]);
    return data;
}

void prepareProcess() {
    [[maybe_unused]] static const bool once = (irsg::keepFreedMemory(), true);
}

void addProjects(py::module_& module) {
    addSettings(module);
    addResults(module);
    ProjectClass project(module, "OpenProject",
                         "A project with settings on top; smat.Project wraps it.");
    project.def(py::init(&opened), py::arg("file"), py::arg("database") = fs::path())
        .def(py::init<const OpenProject&>(), py::arg("other"))
        .def_property_readonly("file", [](const OpenProject& open) { return open.project.file; })
        .def_property_readonly("title", [](const OpenProject& open) { return open.project.title; })
        .def_property_readonly("notes", [](const OpenProject& open) { return open.project.notes; })
        .def_property_readonly("models",
                               [](const OpenProject& open) {
                                   std::vector<std::string> names;
                                   for (const ProjectModel& model : open.project.models)
                                       names.push_back(model.shownName());
                                   return names;
                               })
        .def_property_readonly("analyses",
                               [](const OpenProject& open) {
                                   py::dict kinds;
                                   for (const NamedAnalysis& analysis : open.project.analyses)
                                       kinds[py::str(analysis.name)] = name(analysis.kind);
                                   return kinds;
                               })
        .def(
            "text",
            [](const OpenProject& open, const std::string& key) {
                const SettingInfo* info = findSetting(key);
                if (info == nullptr)
                    throw badArgument("settings", key, expectedSetting(key));
                return open.inEffect().text(info->key);
            },
            py::arg("key"))
        .def("set_texts", &setAll, py::arg("texts"))
        .def_property_readonly("texts",
                               [](const OpenProject& open) {
                                   const Settings all = open.inEffect();
                                   return Texts(all.values().begin(), all.values().end());
                               })
        .def(
            "model_file",
            [](const OpenProject& open, const std::string& model) {
                return open.project.resolve(open.project.models.at(modelOf(open, model)).file);
            },
            py::arg("model"))
        .def(
            "database",
            [](const OpenProject& open, const std::string& model) {
                const fs::path file =
                    open.project.resolve(open.project.models.at(modelOf(open, model)).database);
                return withoutLock([&] {
                    const Pool<JobRunner>::Lease runner(*open.runners);
                    runner->scenes().setDatabaseOverrides(open.databases);
                    return std::make_shared<irsg::SignatureDatabase>(
                        *runner->scenes().database(file));
                });
            },
            py::arg("model"))
        .def(
            "set_database",
            [](OpenProject& open, const Database& database, const std::string& model) {
                open.databases[open.project.resolve(
                    open.project.models.at(modelOf(open, model)).database)] = database;
            },
            py::arg("database").none(false), py::arg("model"))
        .def(
            "save",
            [](const OpenProject& open, const fs::path& file) {
                Project project = open.project;
                project.settings = open.inEffect();
                withoutLock([&] { saveProject(project, file); });
            },
            py::arg("file"))
        .def("run", &runAnalyses, py::arg("kind"), py::arg("analysis"), py::arg("given"),
             py::arg("progress"))
        .def("view", &sceneViewOf)
        .def(py::pickle(
            [](const OpenProject& open) {
                py::dict databases;
                for (const auto& [file, database] : open.databases)
                    databases[py::cast(file)] = irsg::SignatureDatabase(*database);
                const fs::path file =
                    open.project.file.empty() ? fs::path() : fs::absolute(open.project.file);
                Project project = open.project;
                return py::make_tuple(
                    file, projectToJson(project, project.file),
                    Texts(open.overrides.values().begin(), open.overrides.values().end()),
                    databases);
            },
            [](const py::tuple& state) {
                OpenProject open{.project = projectFromJson(state[1].cast<std::string>(),
                                                            state[0].cast<fs::path>())};
                setAll(open, state[2].cast<Texts>());
                for (const auto& [file, database] : state[3].cast<py::dict>())
                    open.databases[file.cast<fs::path>()] = database.cast<Database>();
                return open;
            }));
    addMonteCarlo(module, project);
    addScenarios(module);
    addSensors(module, project);
}

} // namespace smat::python
