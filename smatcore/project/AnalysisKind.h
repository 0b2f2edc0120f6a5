#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smat {

struct AnalysisDefinition;

/// A kind of analysis: a reference to its definition (AnalysisDefinition.h), compared by identity.
class AnalysisKind {
  public:
    /// Those that other parts of the program ask for by name; allAnalysisKinds() has them all.
    static const AnalysisKind image, spectrum, polar, time, range, table;
    /// Tables that are not planned as analyses are: those of tools, and any other.
    static const AnalysisKind radiative, temperatureProfile, gas, monteCarlo, simulation, other;

    constexpr explicit AnalysisKind(const AnalysisDefinition& definition)
        : definition_(&definition) {}
    const AnalysisDefinition* operator->() const { return definition_; }
    friend bool operator==(AnalysisKind, AnalysisKind) = default;
    friend auto operator<=>(AnalysisKind, AnalysisKind) = default;

  private:
    const AnalysisDefinition* definition_;
};

/// What a project can ask for, in the order of menus, commands and manual. Made from the list
/// ANALYSES of smatcore/CMakeLists.txt.
const std::vector<AnalysisKind>& allAnalysisKinds();
/// What makes tables of its own accord, in the order of menus. Made from the list TOOLS there.
const std::vector<AnalysisKind>& allTools();
/// "polar": the word of files and commands, and the section of the settings of this kind alone.
std::string name(AnalysisKind kind);
/// "Polar plot".
std::string title(AnalysisKind kind);
/// One of allAnalysisKinds().
std::optional<AnalysisKind> analysisKindFromName(std::string_view name);
/// What made a result, by the word of its provenance, a former one too: an analysis, a tool, or
/// AnalysisKind::other.
AnalysisKind resultKindFromName(std::string_view name);
/// What analysisKindFromName knows: "image", "spectrum", ...
std::vector<std::string> analysisKindWords();
/// The same as alternatives: "image, spectrum, ... or table".
std::string analysisKindNames();

} // namespace smat
