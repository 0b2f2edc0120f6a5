#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/tables/TableFormats.h"

namespace smat {

std::vector<std::string> usualResultExtensions(AnalysisKind kind) {
    if (kind->form != AnalysisForm::image)
        return {".csv", ".json"};
    std::vector<std::string> extensions;
    for (const irsg::ImageFormat* format : irsg::imageFormats())
        if (format->isUsual)
            extensions.push_back(format->extensionList().front());
    extensions.emplace_back(".json");
    return extensions;
}

std::vector<std::string> resultExtensions(AnalysisKind kind) {
    std::vector<std::string> extensions = {".csv"};
    if (kind->form == AnalysisForm::image)
        extensions = irsg::imageExtensions();
    extensions.emplace_back(".json");
    if (kind->isOverDirections)
        for (const TableFormat* format : tableFormats())
            if (format->isBuilt)
                extensions.emplace_back(format->extension);
    return extensions;
}

void checkResultFile(AnalysisKind kind, const std::filesystem::path& file) {
    const std::vector<std::string> known = resultExtensions(kind);
    if (std::find(known.begin(), known.end(), file.extension().string()) != known.end())
        return;
    const TableFormat* format = kind->isOverDirections ? tableFormatOf(file) : nullptr;
    if (format != nullptr)
        throw irsg::InputError({file.string(), "",
                                std::string(format->name) + ", " + format->extension,
                                std::string("a build with ") + format->library});
    const TableFormat* ofTables = tableFormatOf(file);
    const std::string forTables =
        ofTables == nullptr
            ? ""
            : std::string("; smat-batch table, over two directions, writes ") + ofTables->name;
    throw irsg::InputError(irsg::Diagnostic{
        .file = file.string(),
        .position = "",
        .value = file.has_extension() ? file.extension().string() : "no extension",
        .expected = "a file that ends in " + irsg::alternatives(known) + forTables});
}

void checkResultFile(const AnalysisData& data, const std::filesystem::path& file) {
    checkResultFile(data.image.empty() ? data.kind : AnalysisKind::image, file);
}

void saveResult(const AnalysisData& data, const std::filesystem::path& file) {
    checkResultFile(data, file);
    const std::string extension = file.extension().string();
    const bool isImage = data.kind->form == AnalysisForm::image || !data.image.empty();
    if (data.kind->isOverDirections && tableFormatOf(file) != nullptr) {
        saveTable(data.table, file);
    } else if (!isImage || extension == ".json") {
        data.table.save(file);
    } else if (data.image.empty()) {
        throw irsg::InputError(irsg::Diagnostic{.file = file.string(),
                                                .position = "",
                                                .value = "an analysis without an image",
                                                .expected = "one that was not stopped"});
    } else {
        saveImage(data.image, data.settings,
                  {data.project.title.empty() ? data.name : data.project.title + ": " + data.name,
                   conditionsOf(data.settings)},
                  data.project.displayName(), file);
    }
}

} // namespace smat
