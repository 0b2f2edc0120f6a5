#pragma once

#include <QString>

#include "smatcore/analysis/AnalysisData.h"

namespace smat::gui {

/// "Mean there: 12.3 W·sr⁻¹", in the units of display; spreads and errors in their own.
QString summaryLine(const SummaryItem& item);

} // namespace smat::gui
