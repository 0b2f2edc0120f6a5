#include "smatcore/analysis/ResultFile.h"

#include <algorithm>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/analysis/AnalysisProvenance.h"

namespace smat {

namespace {

/// A sum over the band of a spectrum, `in_band_intensity [W sr-1]`.
void takeInBand(const std::string& key, const std::string& text, std::vector<SummaryItem>& to) {
    const std::size_t unit = key.find(" [");
    if (const auto value = irsg::parseNumber(text); value && unit != key.npos && key.back() == ']')
        to.push_back({key.substr(0, unit), *value, key.substr(unit + 2, key.size() - unit - 3)});
}

void takeProvenance(AnalysisData& data) {
    const Provenance& provenance = data.table.provenance;
    data.kind = resultKindOf(provenance);
    // Whatever else an image says of itself, frames alone are no result of the analysis.
    if (!data.image.empty() && data.kind != AnalysisKind::simulation)
        data.kind = AnalysisKind::image;
    data.name = provenance.value("name");
    data.commandLine = provenance.value("command");
    data.renderer = provenance.value("renderer");
    data.state =
        provenance.value("state") == "partial" ? AnalysisState::partial : AnalysisState::complete;
    for (const auto& [key, value] : provenance.entries)
        if (key == "answered by")
            data.providedBy.push_back(value);
        else if (key == "warning")
            data.warnings.push_back(value);
        else if (key.starts_with("in_band_") && data.kind == AnalysisKind::spectrum)
            takeInBand(key, value, data.inBand);
}

} // namespace

AnalysisKind resultKindOf(const Provenance& provenance) {
    const std::string side = provenance.value("analysis") == "difference" ? "a." : "";
    if (!provenance.value(side + "monte carlo").empty())
        return AnalysisKind::monteCarlo;
    return resultKindFromName(provenance.value(side + "analysis"));
}

AnalysisData resultOf(ResultTable table, const std::string& file) {
    if (table.empty()) {
        throw irsg::InputError(irsg::Diagnostic{.file = file,
                                                .position = "",
                                                .value = "a table without rows",
                                                .expected = "at least one row"});
    }
    AnalysisData data;
    data.table = std::move(table);
    takeProvenance(data);
    summarise(data);
    return data;
}

std::vector<std::string> readableResultExtensions() {
    std::vector<std::string> extensions = irsg::readableImageExtensions();
    extensions.emplace_back(".json");
    return extensions;
}

AnalysisData loadResult(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    // A .csv is a table or an image; all else that images are read from holds nothing else.
    const std::vector<std::string> images = irsg::readableImageExtensions();
    const bool isImage =
        extension == ".csv" ? irsg::holdsImage(file) : std::ranges::count(images, extension) > 0;
    if (isImage) {
        AnalysisData data;
        data.image = irsg::readImageFile(file);
        for (const auto& [key, value] : data.image.attributes)
            data.table.provenance.add(key, value);
        takeProvenance(data);
        summarise(data);
        return data;
    }
    if (extension == ".csv" || extension == ".json")
        return resultOf(ResultTable::load(file), file.string());
    throw irsg::InputError(
        irsg::Diagnostic{.file = file.string(),
                         .position = "",
                         .value = "extension \"" + extension + "\"",
                         .expected = irsg::alternatives(readableResultExtensions())});
}

} // namespace smat
