#pragma once

#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {

/// Settings that were set for this analysis, beside those that its project has for all of its
/// analyses, and that have no effect on it, a sentence each with the reason: settings of other
/// kinds of analysis, those that the analysis varies itself (AnalysisDefinition::ignored), and
/// those of something that there is not, such as the slope of no terrain. Of the settings of the
/// project that of a sensor that reads images alone (image.sensor), which one may take for that of
/// every analysis. `drawsScales`: whether the analysis draws scales whatever scaling.use is.
std::vector<std::string> idleSettingRemarks(const AnalysisData& data, bool drawsScales = false);

} // namespace smat
