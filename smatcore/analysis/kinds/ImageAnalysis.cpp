#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace {

std::vector<SettingInfo> imageSettings() {
    using namespace rows;
    return {
        named(choice(key::imageQuantity, "--quantity", "Quantity",
                     {"radiance", "irradiance", "apparent-temperature", "counts"}, "radiance",
                     "What a pixel holds: in-band radiance, its irradiance on the detector "
                     "(radiance times solid angle times the cosine off the axis), the "
                     "temperature of a black body of that radiance, or the counts of a sensor."),
              {"radiance", "irradiance", "apparent temperature", "counts"}),
        flag(key::imageTruthLayers, "--truth-layers", "Truth layers", false,
             "Adds planes of indices, range and the terms of the radiance to an EXR "
             "file."),
        file(key::imageSensor, "--sensor", "Sensor",
             "File of a sensor (.smatsensor) that reads the image: its blur, noise and counts. It "
             "gives columns, rows, field of view and band, whatever the settings are."),
        integer(key::imageSensorSamples, "--sensor-samples", "Samples per pixel", "", 1, 32, "4",
                "Radiance in front of a sensor is sampled so many times along each side of a "
                "pixel.",
                SettingAudience::expert),
        integer(key::imageNoiseSeed, "--noise-seed", "Seed of the noise", "", 0, 2147483647, "1",
                "Equal seeds give equal noise of a sensor."),
    };
}

void planImage(AnalysisPlan& plan, const Project&, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    const bool hasSensor = !settings[key::imageSensor].empty();
    if (!hasSensor && settings.text(key::imageQuantity) == "counts")
        diagnostics.push_back({"", key::imageQuantity.name, "counts",
                               "another quantity, or a sensor (image.sensor) that counts"});
    if (hasSensor && settings[key::imageTruthLayers])
        diagnostics.push_back({"", key::imageTruthLayers.name, "true",
                               "false with a sensor, whose pixels mix what layers tell apart"});
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
