#include "gui/project/NamedAnalyses.h"
#include "smatcore/settings/AnalysisSections.h"

#include <algorithm>

namespace smat::gui {

Project withAnalysis(const Project& project, const Settings& inEffect, const AnalysisData& data) {
    NamedAnalysis kept{.name = data.name.empty() ? name(data.kind) : data.name, .kind = data.kind};
    const std::string wanted = kept.name;
    for (int number = 2; project.find(kept.name) != nullptr; ++number)
        kept.name = wanted + " " + std::to_string(number);

    // Settings of other kinds of analyses say nothing about this one.
    for (const SettingInfo& info : settingTable())
        if (concerns(info, name(data.kind)) &&
            data.settings.text(info.key) != inEffect.text(info.key))
            kept.settings.set(info.key, data.settings.text(info.key));
    Project changed = project;
    const auto place = std::ranges::upper_bound(changed.analyses, kept.name, {},
                                                [](const auto& one) { return one.name; });
    changed.analyses.insert(place, std::move(kept));
    return changed;
}

Project withoutAnalysis(const Project& project, const std::string& name) {
    Project changed = project;
    std::erase_if(changed.analyses, [&](const auto& one) { return one.name == name; });
    return changed;
}

} // namespace smat::gui
