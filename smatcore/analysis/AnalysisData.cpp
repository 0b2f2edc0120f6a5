#include "smatcore/analysis/AnalysisData.h"

#include "irsg/radiometry/Errors.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

/// A value as the command line takes it: there, paths are relative to where one stands.
std::string commandValue(const Project& project, const Settings& settings,
                         const SettingInfo& setting) {
    if (setting.kind != SettingKind::path && setting.kind != SettingKind::pathList) {
        return settings.text(setting.key);
    }
    std::string text;
    for (const std::filesystem::path& path : settings.paths(setting.key)) {
        const std::string word = path == "vacuum" ? path.string() : project.resolve(path).string();
        text += (text.empty() ? "" : ";") + word;
    }
    return text.empty() ? setting.defaultText : text;
}

} // namespace

AnalysisData AnalysisData::of(const Project& project, const std::string& name) {
    const NamedAnalysis* found = project.find(name);
    if (found == nullptr) {
        std::string names;
        for (const NamedAnalysis& analysis : project.analyses) {
            names += (names.empty() ? "" : ", ") + analysis.name;
        }
        throw irsg::InputError({.file = project.displayName(),
                                .position = "analyses",
                                .value = name,
                                .expected = names.empty()
                                                ? "an analysis, but the project names none"
                                                : "one of " + names});
    }
    AnalysisData data;
    data.name = found->name;
    data.kind = found->kind;
    data.project = project;
    data.settings = project.settings.with(found->settings);
    return data;
}

AnalysisData AnalysisData::of(const Project& project, AnalysisKind kind,
                              const Settings& overrides) {
    AnalysisData data;
    data.name = smat::name(kind);
    data.kind = kind;
    data.project = project;
    data.settings = project.settings.with(overrides);
    return data;
}

std::string AnalysisData::equivalentCommand(const std::string& outputFile) const {
    std::string command = "smat-batch " + smat::name(kind) + " ";
    command += shellQuoted(project.file.empty() ? "PROJECT.smat" : project.file.string());

    // What the project file says is not said again; analysis sections of other kinds do not matter.
    for (const SettingInfo& setting : settingTable()) {
        const std::string& text = settings.text(setting.key);
        const bool concerns =
            !isAnalysisSection(setting.section()) || setting.section() == smat::name(kind);
        if (!concerns || text == project.settings.text(setting.key)) {
            continue;
        }
        if (setting.kind == SettingKind::boolean && text == "true") {
            command += " " + setting.option;
        } else if (setting.kind == SettingKind::boolean) {
            command += " --set " + setting.key + "=false";
        } else {
            command +=
                " " + setting.option + "=" + shellQuoted(commandValue(project, settings, setting));
        }
    }
    return command + " --out " + shellQuoted(outputFile);
}

} // namespace smat
