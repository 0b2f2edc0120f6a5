#include "smatcore/analysis/DetectionProvenance.h"

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"

namespace smat {

void tellDetection(AnalysisData& data, const DetectionScene& shared,
                   const DetectionRequest& request, const TargetSight& seeing) {
    writeProvenance(data, shared.scene);
    data.kind = detectionKind();
    Provenance& provenance = data.table.provenance;
    // A polar plot of these settings has other numbers.
    for (auto& [key, value] : provenance.entries)
        if (key == "analysis")
            value = name(data.kind);
    provenance.add("detection.sensor", request.sensor.title);
    provenance.add("detection.criterion",
                   criterionWords()[static_cast<std::size_t>(request.criterion)]);
    if (seeing.isOfCycles()) {
        provenance.add("detection.cyclesOfHalf", irsg::numberText(request.task.cyclesOfHalf));
        provenance.add("detection.probability", irsg::numberText(request.task.probability));
        provenance.add("detection.cycles", irsg::numberText(seeing.wanted()));
        provenance.add("detection.observer",
                       fmt::format("threshold {}, {} s, {} Hz", request.observer.threshold,
                                   request.observer.integration_s,
                                   request.sensor.electronics.frameRate_Hz));
        for (const std::string& name : request.leftOut)
            provenance.add("detection.leftOut", name);
        if (request.criterion == RangeCriterion::targeting)
            provenance.add("detection.display",
                           fmt::format("{} mrad a pixel, {} cd m-2, {} K of scene contrast",
                                       request.display.pixel_mrad, request.display.luminance_cd_m2,
                                       request.display.sceneContrast_K));
    } else {
        provenance.add("detection.snr", irsg::numberText(request.threshold));
        provenance.add("detection.ensquaredEnergy", irsg::numberText(seeing.energy()));
        if (request.pointProbability) {
            provenance.add("detection.probability", irsg::numberText(*request.pointProbability));
            provenance.add("detection.snrOfProbability", irsg::numberText(seeing.wanted()));
        }
        if (request.measuresClutter)
            provenance.add("detection.clutter", "of the background's pixels");
        if (request.clutter_K > 0.0)
            provenance.add("detection.clutter", irsg::numberText(request.clutter_K) + " K");
    }
    provenance.add("detection.background", request.background_K
                                               ? irsg::numberText(*request.background_K) + " K"
                                               : "of the scene");
}

} // namespace smat
