#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace {

std::vector<SettingInfo> imageSettings() {
    using namespace rows;
    return {
        named(choice(key::imageQuantity, "--quantity", "Quantity",
                     {"radiance", "irradiance", "apparent-temperature"}, "radiance",
                     "What a pixel holds: in-band radiance, its irradiance on the detector "
                     "(radiance times solid angle times the cosine off the axis), or the "
                     "temperature of a black body of that radiance."),
              {"radiance", "irradiance", "apparent temperature"}),
        flag(key::imageTruthLayers, "--truth-layers", "Truth layers", false,
             "Adds planes of indices, range and the terms of the radiance to an EXR "
             "file."),
    };
}

void planImage(AnalysisPlan& plan, const Project&, const Settings& settings,
               std::vector<irsg::Diagnostic>&) {
    plan.columns = {irsg::Quantity::range};
    plan.cases.push_back(startingCase(settings));
}

} // namespace

extern constinit const AnalysisDefinition imageAnalysis{
    .name = "image",
    .title = "Image",
    .help = "One image: radiance, irradiance or apparent temperature",
    .icon = "image",
    .form = AnalysisForm::image,
    .settings = imageSettings,
    .plan = planImage};

} // namespace smat
