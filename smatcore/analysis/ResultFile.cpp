#include "smatcore/analysis/ResultFile.h"

#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFile.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisProvenance.h"

namespace smat {

namespace {

void takeProvenance(AnalysisData& data) {
    const Provenance& provenance = data.table.provenance;
    const std::string analysis = provenance.value("analysis");
    const auto kind =
        analysisKindFromName(analysis == "difference" ? provenance.value("a.analysis") : analysis);
    data.kind = !data.image.empty() ? AnalysisKind::image : kind.value_or(AnalysisKind::range);
    data.name = provenance.value("name");
    data.commandLine = provenance.value("command");
    data.renderer = provenance.value("renderer");
    data.state =
        provenance.value("state") == "partial" ? AnalysisState::partial : AnalysisState::complete;
    for (const auto& [key, value] : provenance.entries) {
        if (key == "answered by") {
            data.answeredBy.push_back(value);
        } else if (key == "warning") {
            data.warnings.push_back(value);
        }
    }
}

} // namespace

AnalysisData loadResult(const std::filesystem::path& file) {
    AnalysisData data;
    const std::string extension = file.extension().string();
    const bool isImage = extension == ".exr" || extension == ".txt" || extension == ".dat" ||
                         (extension == ".csv" && irsg::holdsImage(file));
    if (isImage) {
        data.image = extension == ".exr" ? irsg::readExr(file) : irsg::readImageFile(file);
        for (const auto& [key, value] : data.image.attributes) {
            data.table.provenance.add(key, value);
        }
    } else if (extension == ".csv" || extension == ".json") {
        data.table = ResultTable::load(file);
        if (data.table.empty()) {
            throw irsg::InputError(irsg::Diagnostic{.file = file.string(),
                                                    .position = "",
                                                    .value = "a table without rows",
                                                    .expected = "at least one row"});
        }
    } else {
        throw irsg::InputError(irsg::Diagnostic{.file = file.string(),
                                                .position = "",
                                                .value = "extension \"" + extension + "\"",
                                                .expected = ".csv, .json, .exr, .txt or .dat"});
    }
    takeProvenance(data);
    summarise(data);
    return data;
}

} // namespace smat
