#include "smatcore/analysis/AskedAnalysis.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// What a result says of itself, and how to refuse some of it.
class Told {
  public:
    Told(const Provenance& provenance, const std::filesystem::path& file)
        : provenance_(provenance), file_(file) {}

    const Provenance& all() const { return provenance_; }
    const std::filesystem::path& file() const { return file_; }
    /// All values of that key, joined as attributes of images are; "" where there is none.
    std::string text(const std::string& name) const {
        std::string joined;
        for (const auto& [key, value] : provenance_.entries)
            if (key == name)
                joined += (joined.empty() ? "" : "; ") + value;
        return joined;
    }
    [[noreturn]] void refuse(const std::string& name, const std::string& value,
                             const std::string& expected) const {
        throw irsg::InputError({file_.filename().string(), name, value, expected});
    }

  private:
    const Provenance& provenance_;
    const std::filesystem::path& file_;
};

/// Where a project may lie of which a result knows the name.
std::optional<std::filesystem::path> projectNear(const std::filesystem::path& result,
                                                 const std::string& name) {
    const std::filesystem::path folder = result.parent_path();
    for (const auto& place : {folder, folder / "..", std::filesystem::path()}) {
        std::error_code failure;
        if (std::filesystem::is_regular_file(place / name, failure))
            return (place / name).lexically_normal();
    }
    return std::nullopt;
}

Project projectOf(const Told& told, const std::vector<Project>& open) {
    const std::string name = told.text("project");
    if (std::filesystem::path(name).extension() != ".smat")
        told.refuse("project", name.empty() ? "nothing" : "'" + name + "'",
                    "the file of a project: a result of a bare model does not say how that was "
                    "opened");
    const auto known = std::ranges::find(open, name, &Project::displayName);
    if (known != open.end())
        return *known;
    const auto found = projectNear(told.file(), name);
    if (!found)
        told.refuse("project", name + ", which is neither open nor beside the result",
                    "its project beside it, or open");
    return loadProject(*found);
}

/// Files that the project has now under the names that the result knows.
void checkModels(const Told& told, const Project& project) {
    std::string models, databases;
    for (const ProjectModel& model : project.models) {
        const auto add = [](std::string& list, const std::filesystem::path& path) {
            list += (list.empty() ? "" : "; ") + path.filename().string();
        };
        add(models, model.file);
        add(databases, model.database);
    }
    const std::string now = "those of " + project.displayName() + " now: ";
    if (told.text("database").find("edits that are not saved") != std::string::npos)
        told.refuse("database", told.text("database"), "a database as it was saved");
    if (told.text("model") != models)
        told.refuse("model", told.text("model"), now + models);
    if (told.text("database") != databases)
        told.refuse("database", told.text("database"), now + databases);
}

AnalysisData analysisOf(const Told& told, const std::vector<Project>& open) {
    const std::string analysis = told.text("analysis");
    if (!told.text("program").starts_with("smat ") || analysis.empty())
        told.refuse("", "a result that does not say how it was computed",
                    "one that an analysis of this program wrote");
    // Its table names the analysis that was repeated, and a run of that has other numbers.
    if (const std::string draws = told.text("monte carlo"); !draws.empty())
        told.refuse("monte carlo", draws,
                    "a result of one run: Monte Carlo is run again by the command " +
                        name(AnalysisKind::monteCarlo));
    const auto kind = analysisKindFromName(analysis);
    if (!kind)
        told.refuse("analysis", analysis, analysisKindNames());
    AnalysisData data;
    data.kind = *kind;
    data.name = told.text("name");
    data.project = projectOf(told, open);
    checkModels(told, data.project);
    // What is not told had its default.
    ResultTable settings;
    settings.provenance = told.all();
    data.settings = settingsOf(settings);
    for (const auto& [key, value] : told.all().entries)
        if (findSetting(key) != nullptr && !data.settings.isSet(key))
            told.refuse(key, value, "a value that this version knows");
    // Where adaptive steps are not told there were none.
    if (told.text(key::stepsOf(analysis)).empty())
        data.settings = withFixedSteps(data.kind, data.settings);
    data.project.settings = data.settings;
    return data;
}

} // namespace

AnalysisData analysisOfResult(const AnalysisData& loaded, const std::filesystem::path& file,
                              const std::vector<Project>& open) {
    return loaded.image.empty() ? analysisOf(Told(loaded.table.provenance, file), open)
                                : analysisOfImage(loaded.image, file, open);
}

AnalysisData analysisOfImage(const irsg::RadianceImage& image, const std::filesystem::path& file,
                             const std::vector<Project>& open) {
    Provenance provenance;
    for (const auto& [key, value] : image.attributes)
        provenance.add(key, value);
    const Told told(provenance, file);
    AnalysisData data = analysisOf(told, open);
    if (data.kind != AnalysisKind::image)
        told.refuse("analysis", name(data.kind), "image");
    const int width = data.settings[key::sensorWidth], height = data.settings[key::sensorHeight];
    if (width != image.width() || height != image.height())
        told.refuse(
            "", std::to_string(image.width()) + " x " + std::to_string(image.height()) + " pixels",
            "those of its sensor, " + std::to_string(width) + " x " + std::to_string(height));
    return data;
}

} // namespace smat
