#include "smatcore/analysis/AnalysisOfResult.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// What a result says of itself, and how to refuse some of it.
class StatedProvenance {
  public:
    StatedProvenance(const Provenance& provenance, const std::filesystem::path& file)
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

Project projectOf(const StatedProvenance& stated, const std::vector<Project>& open,
                  std::vector<std::string>* remarks) {
    const std::string name = stated.text("project");
    if (std::filesystem::path(name).extension() != ".smat")
        stated.refuse("project", name.empty() ? "nothing" : "'" + name + "'",
                      "the file of a project: a result of a bare model does not say how that was "
                      "opened");
    const auto known = std::ranges::find(open, name, &Project::displayName);
    if (known != open.end())
        return *known;
    const auto found = projectNear(stated.file(), name);
    if (!found) {
        // One that was given or opened under another name is named: it may be what was meant.
        std::string others;
        for (const Project& other : open)
            others += (others.empty() ? " (open: " : ", ") + other.displayName();
        if (!others.empty())
            others += ")";
        stated.refuse("project",
                      name + ", which is neither open" + others + " nor beside the result",
                      "its project under this name, beside it or open");
    }
    return loadProject(*found, remarks);
}

/// Files that the project has now under the names that the result knows.
void checkModels(const StatedProvenance& stated, const Project& project) {
    std::string models, databases;
    for (const ProjectModel& model : project.models) {
        const auto add = [](std::string& list, const std::filesystem::path& path) {
            list += (list.empty() ? "" : "; ") + path.filename().string();
        };
        add(models, model.file);
        add(databases, model.database);
    }
    const std::string now = "those of " + project.displayName() + " now: ";
    if (stated.text("database").find("edits that are not saved") != std::string::npos)
        stated.refuse("database", stated.text("database"), "a database as it was saved");
    if (stated.text("model") != models)
        stated.refuse("model", stated.text("model"), now + models);
    if (stated.text("database") != databases)
        stated.refuse("database", stated.text("database"), now + databases);
}

AnalysisData analysisOf(const StatedProvenance& stated, const std::vector<Project>& open,
                        std::vector<std::string>* remarks) {
    const std::string analysis = stated.text("analysis");
    if (!stated.text("program").starts_with("smat ") || analysis.empty())
        stated.refuse("", "a result that does not say how it was computed",
                      "one that an analysis of this program wrote");
    // Its table names the analysis that was repeated, and a run of that has other numbers.
    if (const std::string realisations = stated.text("monte carlo"); !realisations.empty())
        stated.refuse("monte carlo", realisations,
                      "a result of one run: Monte Carlo is run again by the command " +
                          name(AnalysisKind::monteCarlo));
    const auto kind = analysisKindFromName(analysis);
    if (!kind)
        stated.refuse("analysis", analysis, analysisKindNames());
    AnalysisData data;
    data.kind = *kind;
    data.name = stated.text("name");
    data.project = projectOf(stated, open, remarks);
    checkModels(stated, data.project);
    // What is not stated had its default.
    ResultTable settings;
    settings.provenance = stated.all();
    data.settings = settingsOf(settings);
    for (const auto& [key, value] : stated.all().entries)
        if (const SettingInfo* setting = findSetting(key);
            setting != nullptr && !data.settings.isSet(setting->key))
            stated.refuse(key, value, "a value that this version knows");
    if (remarks != nullptr)
        for (const auto& [key, value] : stated.all().entries)
            irsg::appendUnique(*remarks, formerNameRemarks(key, value));
    // Where adaptive steps are not stated there were none.
    if (stated.text(key::stepsOf(analysis)).empty())
        data.settings = withFixedSteps(data.kind, data.settings);
    data.project.settings = data.settings;
    return data;
}

/// Earlier versions had no errors by default: a result that neither states nor has some is run
/// without.
void takeErrorsFrom(const AnalysisData& loaded, AnalysisData& data) {
    const auto isError = [](const std::string& key) {
        return key.starts_with(errorPrefixes(ErrorColumns::sum).front());
    };
    const bool hasErrors =
        std::ranges::any_of(loaded.table.columns(), isError, &ResultColumn::key) ||
        std::ranges::any_of(loaded.image.attributes,
                            [&](const auto& attribute) { return isError(attribute.first); });
    if (hasErrors || !data.settings.isDefault(key::renderErrors))
        return;
    data.settings.set(key::renderErrors, "off");
    data.project.settings = data.settings;
}

} // namespace

AnalysisData analysisOfResult(const AnalysisData& loaded, const std::filesystem::path& file,
                              const std::vector<Project>& open, std::vector<std::string>* remarks) {
    AnalysisData data =
        loaded.image.empty()
            ? analysisOf(StatedProvenance(loaded.table.provenance, file), open, remarks)
            : analysisOfImage(loaded.image, file, open, remarks);
    takeErrorsFrom(loaded, data);
    return data;
}

AnalysisData analysisOfImage(const irsg::RadianceImage& image, const std::filesystem::path& file,
                             const std::vector<Project>& open, std::vector<std::string>* remarks) {
    Provenance provenance;
    for (const auto& [key, value] : image.attributes)
        provenance.add(key, value);
    const StatedProvenance stated(provenance, file);
    AnalysisData data = analysisOf(stated, open, remarks);
    if (data.kind != AnalysisKind::image)
        stated.refuse("analysis", name(data.kind), "image");
    const int width = data.settings[key::sensorWidth], height = data.settings[key::sensorHeight];
    if (width != image.width() || height != image.height())
        stated.refuse(
            "", std::to_string(image.width()) + " x " + std::to_string(image.height()) + " pixels",
            "those of its sensor, " + std::to_string(width) + " x " + std::to_string(height));
    return data;
}

} // namespace smat
