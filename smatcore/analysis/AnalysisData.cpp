#include "smatcore/analysis/AnalysisData.h"

#include "irsg/core/Errors.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

/// A value as the command line takes it: there, paths are relative to where one stands.
std::string commandValue(const Project& project, const Settings& settings,
                         const SettingInfo& setting) {
    if (setting.kind != SettingKind::path && setting.kind != SettingKind::pathList)
        return settings.text(setting.key);
    std::string text;
    for (const std::filesystem::path& path : settings[PathsKey{setting.key.c_str()}]) {
        const std::string word = path == "vacuum" ? path.string() : project.resolve(path).string();
        text += (text.empty() ? "" : ";") + word;
    }
    return text.empty() ? setting.defaultText : text;
}

/// A project with no more than one of its analyses: a result keeps its project, and thousands of
/// analyses that each kept them all would take the square of their number.
Project withAnalysis(const Project& project, const NamedAnalysis* analysis) {
    Project alone{project.file, project.title,      project.notes, project.models, project.settings,
                  {},           project.unknownKeys};
    if (analysis != nullptr)
        alone.analyses.push_back(*analysis);
    return alone;
}

} // namespace

AnalysisData AnalysisData::of(const Project& project, const std::string& name) {
    const NamedAnalysis* found = project.find(name);
    if (found == nullptr) {
        std::vector<std::string> names;
        for (const NamedAnalysis& analysis : project.analyses)
            names.push_back(analysis.name);
        throw irsg::InputError({.file = project.displayName(),
                                .position = "analyses",
                                .value = name,
                                .expected = names.empty()
                                                ? "an analysis, but the project names none"
                                                : oneOf(names, name)});
    }
    AnalysisData data;
    data.name = found->name;
    data.kind = found->kind;
    data.project = withAnalysis(project, found);
    data.settings = project.settings.with(found->settings);
    return data;
}

AnalysisData AnalysisData::of(const Project& project, AnalysisKind kind,
                              const Settings& overrides) {
    AnalysisData data;
    data.name = smat::name(kind);
    data.kind = kind;
    data.project = withAnalysis(project, nullptr);
    data.settings = project.settings.with(overrides);
    return data;
}

std::string AnalysisData::equivalentCommand(const std::string& outputFile) const {
    std::string command = "smat-batch " + smat::name(kind) + " ";
    command += shellQuoted(project.file.empty() ? "PROJECT.smat" : project.file.string());
    // What the project file says is not said again.
    command += settingOptions(project, settings, project.settings, kind);
    return command + " --out " + shellQuoted(outputFile);
}

std::string settingOptions(const Project& project, const Settings& now, const Settings& known,
                           AnalysisKind kind, bool assigned) {
    std::string options;
    for (const SettingInfo& setting : settingTable()) {
        const std::string& text = now.text(setting.key);
        if (!concerns(setting, name(kind)) || text == known.text(setting.key))
            continue;
        if (setting.kind == SettingKind::boolean && text == "true" && !assigned) {
            options += " " + setting.option;
        } else if (setting.kind == SettingKind::boolean) {
            options += " --set " + setting.key + "=" + text;
        } else {
            const std::string value = commandValue(project, now, setting);
            options += assigned ? " --set " + shellQuoted(setting.key + "=" + value)
                                : " " + setting.option + "=" + shellQuoted(value);
        }
    }
    return options;
}

} // namespace smat
