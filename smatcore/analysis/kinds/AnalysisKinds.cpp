#include <algorithm>

#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/settings/AnalysisSections.h"

namespace smat {

extern const AnalysisDefinition imageAnalysis, spectrumAnalysis, polarAnalysis, timeAnalysis,
    rangeAnalysis, tableAnalysis, radiativeTool, temperatureProfileTool, gasTool, monteCarloTool,
    simulationTool, otherTable;

constinit const AnalysisKind AnalysisKind::image(imageAnalysis);
constinit const AnalysisKind AnalysisKind::spectrum(spectrumAnalysis);
constinit const AnalysisKind AnalysisKind::polar(polarAnalysis);
constinit const AnalysisKind AnalysisKind::time(timeAnalysis);
constinit const AnalysisKind AnalysisKind::range(rangeAnalysis);
constinit const AnalysisKind AnalysisKind::table(tableAnalysis);
constinit const AnalysisKind AnalysisKind::radiative(radiativeTool);
constinit const AnalysisKind AnalysisKind::temperatureProfile(temperatureProfileTool);
constinit const AnalysisKind AnalysisKind::gas(gasTool);
constinit const AnalysisKind AnalysisKind::monteCarlo(monteCarloTool);
constinit const AnalysisKind AnalysisKind::simulation(simulationTool);
constinit const AnalysisKind AnalysisKind::other(otherTable);

std::string name(AnalysisKind kind) {
    return kind->name;
}

std::string title(AnalysisKind kind) {
    return kind->title;
}

std::optional<AnalysisKind> analysisKindFromName(std::string_view text) {
    const auto& kinds = allAnalysisKinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](AnalysisKind kind) { return kind->name == text; });
    return found == kinds.end() ? std::nullopt : std::optional(*found);
}

AnalysisKind resultKindFromName(std::string_view text) {
    for (const AnalysisKind tool : allTools())
        if (tool->name == text || (tool->formerName != nullptr && tool->formerName == text))
            return tool;
    return analysisKindFromName(text).value_or(AnalysisKind::other);
}

std::vector<std::string> analysisKindWords() {
    std::vector<std::string> words;
    for (const AnalysisKind kind : allAnalysisKinds())
        words.push_back(name(kind));
    return words;
}

std::string analysisKindNames() {
    return irsg::alternatives(analysisKindWords());
}

const std::vector<AnalysisSection>& analysisSections() {
    // The rows live as long as the program: sections point at them.
    static const std::vector<std::vector<SettingInfo>> rows = [] {
        std::vector<std::vector<SettingInfo>> made;
        for (const AnalysisKind kind : allAnalysisKinds()) {
            made.push_back(kind->settings != nullptr ? kind->settings()
                                                     : std::vector<SettingInfo>{});
        }
        return made;
    }();
    static const std::vector<AnalysisSection> sections = [] {
        std::vector<AnalysisSection> made;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const AnalysisKind kind = allAnalysisKinds()[i];
            made.push_back({kind->name, kind->title, &rows[i]});
        }
        return made;
    }();
    return sections;
}

} // namespace smat
