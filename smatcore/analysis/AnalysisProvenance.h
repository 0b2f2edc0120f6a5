#pragma once

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// Says in the table and in the attributes of the image how the result came to be: program, inputs,
/// band, settings that differ from their defaults, renderer, who answered for the air, warnings.
/// Holds no clock: equal inputs give equal files.
void writeProvenance(AnalysisData& data, const SceneDescription& scene);

/// Fills in the numbers worth saying: the extremes of a sweep and where they are, the sums and
/// extremes of an image.
void summarise(AnalysisData& data);

} // namespace smat
