#include "smatcore/analysis/AnalysisProvenance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/BuildId.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/InputFiles.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/data/TableAxes.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/project/SceneScalings.h"
#include "smatcore/settings/AnalysisSections.h"

namespace smat {

namespace {

using irsg::Quantity;

/// What the table has beside a number.
std::optional<double> errorBeside(const ResultTable& table, ColumnName name, std::size_t row) {
    name.prefix = errorPrefixes(ErrorColumns::sum).front();
    const ResultColumn* column = table.find(name.key());
    if (column == nullptr || !std::isfinite(column->values.at(row)))
        return std::nullopt;
    return column->values[row];
}

void addColumnExtremes(AnalysisData& data, Quantity quantity,
                       const std::vector<const ResultColumn*>& axes) {
    for (const ResultColumn* column : columnsOf(data.table, irsg::info(quantity).key)) {
        const ColumnName parts = ColumnName::of(column->key);
        // Of all objects together, in each band.
        if (column->values.empty() || !parts.object.empty())
            continue;
        const auto [least, most] =
            std::minmax_element(column->values.begin(), column->values.end());
        const std::string band = parts.band.empty() ? "" : ", " + parts.which() + ",";
        std::string label = std::string(irsg::info(quantity).label) + band;
        label.front() = irsg::lowerCase({label.front()}).front();
        const auto add = [&](const char* which, std::vector<double>::const_iterator it) {
            const auto row = static_cast<std::size_t>(it - column->values.begin());
            data.summary.push_back({fmt::format("{} {} at {}", which, label, rowPlace(axes, row)),
                                    *it, column->unit, errorBeside(data.table, parts, row)});
        };
        add("Highest", most);
        add("Lowest", least);
    }
}

/// What the parts of objects add to the largest contrast, the largest first.
void addLargestParts(AnalysisData& data, const std::vector<const ResultColumn*>& axes) {
    constexpr std::size_t most = 5;
    const auto columns = columnsOf(data.table, irsg::info(Quantity::contrastIntensity).key);
    for (const ResultColumn* whole : columns) {
        const ColumnName name = ColumnName::of(whole->key);
        if (whole->values.empty() || !name.object.empty())
            continue;
        const auto row = static_cast<std::size_t>(std::ranges::max_element(whole->values) -
                                                  whole->values.begin());
        std::vector<SummaryItem> parts;
        for (const ResultColumn* column : columns)
            if (const ColumnName own = ColumnName::of(column->key);
                !own.part().empty() && own.band == name.band && column->values[row] != 0.0)
                parts.push_back({fmt::format("{} of the largest contrast, at {}", own.which(),
                                             rowPlace(axes, row)),
                                 column->values[row], column->unit});
        std::ranges::stable_sort(parts, std::ranges::greater(),
                                 [](const SummaryItem& part) { return std::abs(part.value); });
        parts.resize(std::min(parts.size(), most));
        data.summary.insert(data.summary.end(), parts.begin(), parts.end());
    }
}

/// "east 300 m, north 0 m, altitude 100 m, heading 90 deg, pitch 0 deg, roll 0 deg, power 0.4":
/// where a model stands that is not the target, and what it does by itself.
std::string placeWords(const Project& project, std::size_t model) {
    std::string words;
    for (const ModelField& field : modelFields()) {
        const std::string text = textOf(project, model, field);
        const bool isOfPlace = field.info.unit == "m" || field.info.unit == "deg";
        if (field.key == "yaw" || (!isOfPlace && text == field.info.defaultText))
            continue;
        words += fmt::format("{}{} {}{}{}", words.empty() ? "" : ", ", field.key, text,
                             field.info.unit.empty() ? "" : " ", field.info.unit);
    }
    return words;
}

void addImageNumbers(AnalysisData& data) {
    const irsg::ImageChannel& channel = data.image.primary();
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const float value : channel.values) {
        if (std::isfinite(value)) {
            least = std::min(least, static_cast<double>(value));
            most = std::max(most, static_cast<double>(value));
        }
    }
    if (least <= most) {
        data.summary.push_back({"Highest pixel", most, channel.unit});
        data.summary.push_back({"Lowest pixel", least, channel.unit});
    }
    for (const Quantity quantity : {Quantity::intensity, Quantity::contrastIntensity,
                                    Quantity::irradiance, Quantity::pixels}) {
        const ResultColumn* column = data.table.find(quantity);
        if (column != nullptr && !column->values.empty()) {
            data.summary.push_back({std::string(irsg::info(quantity).label), column->values.front(),
                                    column->unit,
                                    errorBeside(data.table, ColumnName::of(column->key), 0)});
        }
    }
}

} // namespace

void summarise(AnalysisData& data) {
    data.summary.clear();
    if (!data.image.empty()) {
        addImageNumbers(data);
    } else if (data.kind->form == AnalysisForm::spectrum) {
        addColumnExtremes(data, Quantity::spectralContrastIntensity, axesOf(data.table));
        data.summary.insert(data.summary.end(), data.inBand.begin(), data.inBand.end());
    } else if (!data.table.empty() && irsg::quantityOfKey(data.table.columns().front().key)) {
        const std::vector<const ResultColumn*> axes = axesOf(data.table);
        addColumnExtremes(data, Quantity::contrastIntensity, axes);
        addColumnExtremes(data, Quantity::irradiance, axes);
        addLargestParts(data, axes);
    }
}

void writeProvenance(AnalysisData& data, const SceneDescription& scene) {
    Provenance provenance;
    provenance.add("program", irsg::programWithVersion());
    provenance.add("analysis", name(data.kind));
    provenance.add("name", data.name);
    provenance.add("state", data.state == AnalysisState::complete ? "complete" : "partial");
    if (!data.commandLine.empty())
        provenance.add("command", data.commandLine);
    provenance.add("project", data.project.displayName());
    for (std::size_t i = 0; i < data.project.models.size(); ++i) {
        const ProjectModel& model = data.project.models[i];
        provenance.add("model", model.file.filename().string());
        const bool unsaved = scene.unsavedDatabases.contains(i);
        provenance.add("database", model.database.filename().string() +
                                       (unsaved ? ", with edits that are not saved" : ""));
        if (i > 0)
            provenance.add("place", placeWords(data.project, i));
    }
    for (const InputFile& input : inputFilesOf(data.project, data.settings, data.kind)) {
        const bool isUnsaved =
            input.role == "database" && scene.unsavedDatabases.contains(input.number);
        if (const std::string hash = isUnsaved ? "" : contentHash(input.file); !hash.empty())
            provenance.add("input", hash + " " + input.role + " " + input.file.filename().string());
    }
    for (const irsg::Band& band : scene.allBands()) {
        const irsg::SpectralRange range = band.range();
        provenance.add("band",
                       fmt::format("{} ({} to {} um)", band.name(), range.min_um, range.max_um));
    }
    for (const SettingInfo& setting : settingTable()) {
        // How the cases stand is told where they follow the curves, asked for or not.
        if (setting.key == key::stepsOf(name(data.kind)) &&
            data.settings.text(setting.key) == "auto" && isAdaptivePlot(data.kind, data.settings))
            provenance.add(setting.key, "adaptive");
        if (concerns(setting, name(data.kind)) && !data.settings.isDefault(setting.key)) {
            const std::string unit = setting.unit.empty() ? "" : " " + setting.unit;
            provenance.add(setting.key, data.settings.text(setting.key) + unit);
        }
    }
    tellSampledScales(scene, data.settings, provenance);
    if (!irsg::buildId().empty())
        provenance.add("build", irsg::buildId());
    for (const SummaryItem& item : data.inBand)
        provenance.add(item.label + " [" + item.unit + "]", irsg::numberText(item.value));
    provenance.add("renderer", data.renderer);
    for (const std::string& answer : data.providedBy)
        provenance.add("answered by", answer);
    for (const std::string& warning : data.warnings)
        provenance.add("warning", warning);

    // An image carries the same as attributes, in place of what it said of itself (the renderer);
    // what occurs more than once is joined.
    if (!data.image.empty()) {
        for (const auto& [key, value] : provenance.entries)
            data.image.attributes.erase(key);
        for (const auto& [key, value] : provenance.entries) {
            std::string& attribute = data.image.attributes[key];
            attribute += (attribute.empty() ? "" : "; ") + value;
        }
    }
    data.table.provenance = std::move(provenance);
}

} // namespace smat
