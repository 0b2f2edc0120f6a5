#pragma once

#include "smatcore/analysis/TargetAspect.h"

namespace smat {

/// Makes a result of a detection: its kind, and what its provenance says of how it was asked for.
void tellDetection(AnalysisData& data, const DetectionScene& shared,
                   const DetectionRequest& request, const TargetSight& seeing);

} // namespace smat
