#pragma once

#include <string_view>
#include <vector>

#include "smatcore/settings/SettingInfo.h"

namespace smat {

/// The settings that belong to one kind of analysis. Their table stands with the definition of the
/// kind (smatcore/analysis/kinds), not here.
struct AnalysisSection {
    std::string_view name;  ///< "polar"
    std::string_view title; ///< "Polar plot"
    const std::vector<SettingInfo>* settings;
};

/// In the order of forms and manual; defined by the registry of analyses.
const std::vector<AnalysisSection>& analysisSections();

/// Whether a setting takes part in an analysis of this name: all do but those of other kinds. For
/// an empty name those of every kind are left out.
bool concerns(const SettingInfo& setting, std::string_view analysis);

} // namespace smat
