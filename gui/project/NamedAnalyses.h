#pragma once

#include <string>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

/// The project with an analysis that was run as one of its own: what of its settings differs from
/// those of the project, `inEffect`, under the name of the analysis, or that name and a number
/// where it is taken.
Project withAnalysis(const Project& project, const Settings& inEffect, const AnalysisData& data);
/// The project without the analysis of this name.
Project withoutAnalysis(const Project& project, const std::string& name);

} // namespace smat::gui
