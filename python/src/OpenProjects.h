#pragma once

#include <memory>
#include <string>

#include "python/src/Bindings.h"
#include "python/src/Pool.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/project/Project.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::python {

/// A project as its file has it, with what the caller has put on top: settings, which go before
/// those of its analyses, too, and databases. Copies share the models that were loaded.
struct OpenProject {
    Project project;
    Settings overrides = {};
    SceneBuilder::DatabaseOverrides databases = {};
    std::shared_ptr<Pool<JobRunner>> runners = std::make_shared<Pool<JobRunner>>();

    Settings inEffect() const { return project.settings.with(overrides); }
};

/// An analysis of a kind, or, where it is named, of the project, with the settings on top. Throws
/// InputError for words that are neither.
AnalysisData analysisOf(const OpenProject& open, const std::string& kind,
                        const std::string& analysis);

/// What the programs do once before they compute.
void prepareProcess();

/// A Python class of OpenProject, to which other files add methods.
using ProjectClass = py::class_<OpenProject>;
void addMonteCarlo(py::module_& module, ProjectClass& project);
void addScenarios(py::module_& module);
void addSensors(py::module_& module, ProjectClass& project);

} // namespace smat::python
