#pragma once

#include <string>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/DetectionRequest.h"

namespace smat {

/// Fills the table of `data` with ranges over the values of request.comparison, each of all cases
/// of the request: a row for each value, with `wind` in m/s, `visibility` in m, `humidity` in %,
/// `hour` in h, `band_from` and `band_to` in um, `emissivity` of a grey paint, or where any paint
/// has a name `paint`, from 1 on in the order of the values, which the summary names. Then
/// `detection_range`, the mean over the cases, with its error at two standard deviations (those of
/// the cases count as one and the same), `least_range`, `greatest_range`, and `nowhere` and
/// `beyond`, how many cases have no range and are seen at the farthest. With measured clutter also
/// `clutter`, the mean.
///
/// A wind is that of now and of the last day. Hours set the time of temperature tables, and the
/// sun where a place is given; hours are of mean solar time there, else the sun stays. A band is
/// that of the sensor, whose spectra must cover it. A paint takes the place of the material of the
/// target that is named. A stop keeps the values that are done. Throws InputError, also for a value
/// that changes nothing of this scene.
void runDetectionComparison(AnalysisData& data, const DetectionRequest& request,
                            const RenderDoor& door, const SceneFactory& scenes,
                            const RunControl& control);

/// The options of the command that ask for it, each with a blank before it.
std::string comparisonOptions(const RangeComparison& comparison);

} // namespace smat
