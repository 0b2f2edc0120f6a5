#include "apps/smat-batch/ProjectInput.h"

#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/ProjectFile.h"

namespace smat::batch {

Project openProject(const std::string& file) {
    std::vector<std::string> remarks;
    Project project = loadProject(file, &remarks);
    for (const std::string& remark : remarks)
        warn(file + ": " + remark);
    return project;
}

ProjectInput::ProjectInput(CLI::App& command) : placing_(command) {
    command.add_option("PROJECT", file_, "Project file (.smat), or a model")
        ->required()
        ->type_name("");
    command.add_option("--database", database_, "Signature database (.sigdb) of a bare model")
        ->type_name("FILE");
}

Project ProjectInput::load() const {
    const std::filesystem::path file(file_);
    if (file.extension() != ".smat") {
        Project project = projectOfModel(file, database_);
        project.models.front().options = placing_.over({});
        return project;
    }
    refuseOptionsFor("a project");
    Project project = openProject(file_);
    for (const std::string& key : unknownKeys(project))
        warn(file_ + ": the key " + key + " is not known to this version and has no effect" +
             knownKeysLike(key));
    return project;
}

void ProjectInput::refuseOptionsFor(const std::string& what) const {
    if (!database_.empty()) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = "--database",
                             .position = "",
                             .value = database_,
                             .expected = "no database: " + what + " names its own"});
    }
    if (!placing_.given().empty()) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = placing_.given(),
                             .position = "",
                             .value = file_,
                             .expected = "a bare model: " + what + " places its own"});
    }
}

} // namespace smat::batch
