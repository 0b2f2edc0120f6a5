#include "smatcore/project/Project.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "smatcore/project/NamedPaths.h"

namespace smat {

std::filesystem::path Project::resolve(const std::filesystem::path& path) const {
    return namedPath(file, path).file;
}

const NamedAnalysis* Project::find(std::string_view analysis) const {
    const auto found = std::find_if(analyses.begin(), analyses.end(),
                                    [&](const NamedAnalysis& one) { return one.name == analysis; });
    return found == analyses.end() ? nullptr : &*found;
}

std::string Project::displayName() const {
    if (!file.empty())
        return file.filename().string();
    return title.empty() ? "new project" : title;
}

ModelKey ModelKey::of(const Project& project, const ProjectModel& model) {
    return {project.resolve(model.file), model.options};
}

Project projectOfModel(const std::filesystem::path& model, const std::filesystem::path& database) {
    Project project;
    ProjectModel target;
    target.name = model.stem().string();
    target.file = model;
    target.database = database;
    if (database.empty()) {
        const std::filesystem::path beside[] = {
            std::filesystem::path(model).replace_extension(".sigdb"),
            model.parent_path() / "signature.sigdb"};
        for (const std::filesystem::path& candidate : beside) {
            if (std::filesystem::is_regular_file(candidate)) {
                target.database = candidate;
                break;
            }
        }
    }
    project.title = target.name;
    project.models.push_back(std::move(target));
    return project;
}

} // namespace smat
