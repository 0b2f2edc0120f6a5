#include <algorithm>

#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/image/PngView.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisData.h"

namespace smat {

namespace {

/// The limits of the colours: those that are set, the image's own for the others.
irsg::DisplayLimits limitsOf(const AnalysisData& data) {
    irsg::DisplayLimits limits = irsg::objectLimits(data.image.primary().values);
    const auto minimum = data.settings.optionalReal("display.minimum");
    const auto maximum = data.settings.optionalReal("display.maximum");
    limits.low = minimum.value_or(limits.low);
    limits.high = maximum.value_or(limits.high);
    if (limits.low >= limits.high) {
        throw irsg::InputError(
            irsg::Offence{.file = data.project.displayName(),
                          .position = maximum ? "display.maximum" : "display.minimum",
                          .value = maximum ? data.settings.text("display.maximum")
                                           : data.settings.text("display.minimum"),
                          .expected = "a least value below the largest that is shown"});
    }
    return limits;
}

void savePng(const AnalysisData& data, const std::filesystem::path& file) {
    irsg::PngViewOptions options;
    options.colorMap = data.settings.text("display.colorMap");
    options.limits = limitsOf(data);
    options.title = data.project.title.empty() ? data.name : data.project.title + ": " + data.name;
    irsg::writePngView(data.image, file, options);
}

} // namespace

std::vector<std::string> resultExtensions(AnalysisKind kind) {
    return kind == AnalysisKind::image ? std::vector<std::string>{".exr", ".csv", ".png", ".json"}
                                       : std::vector<std::string>{".csv", ".json"};
}

void checkResultFile(AnalysisKind kind, const std::filesystem::path& file) {
    const std::vector<std::string> known = resultExtensions(kind);
    if (std::find(known.begin(), known.end(), file.extension().string()) != known.end()) {
        return;
    }
    std::string list;
    for (const std::string& extension : known) {
        list += (list.empty() ? "" : ", ") + extension;
    }
    throw irsg::InputError(
        irsg::Offence{.file = file.string(),
                      .position = "",
                      .value = file.has_extension() ? file.extension().string() : "no extension",
                      .expected = "a file of one of " + list});
}

void saveResult(const AnalysisData& data, const std::filesystem::path& file) {
    checkResultFile(data.kind, file);
    const std::string extension = file.extension().string();
    if (data.kind != AnalysisKind::image || extension == ".json") {
        data.table.save(file);
    } else if (data.image.empty()) {
        throw irsg::InputError(irsg::Offence{.file = file.string(),
                                             .position = "",
                                             .value = "an analysis without an image",
                                             .expected = "one that was not stopped"});
    } else if (extension == ".exr") {
        irsg::writeExr(data.image, file);
    } else if (extension == ".png") {
        savePng(data, file);
    } else {
        irsg::writeCsvImage(data.image, file);
    }
}

} // namespace smat
