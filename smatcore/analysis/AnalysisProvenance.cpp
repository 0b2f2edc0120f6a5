#include "smatcore/analysis/AnalysisProvenance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/settings/AnalysisSections.h"

namespace smat {

namespace {

using irsg::Quantity;

void addColumnExtremes(AnalysisData& data, Quantity quantity, Quantity abscissa) {
    const ResultColumn* axis = data.table.find(abscissa);
    for (const ResultColumn* column : columnsOf(data.table, irsg::info(quantity).key)) {
        const ColumnName parts = ColumnName::of(column->key);
        // Of all objects together, in each band.
        if (axis == nullptr || column->values.empty() || !parts.object.empty())
            continue;
        const auto [least, most] =
            std::minmax_element(column->values.begin(), column->values.end());
        const std::string band = parts.band.empty() ? "" : ", " + parts.which() + ",";
        const std::string label = std::string(irsg::info(quantity).label) + band;
        const auto where = [&](std::vector<double>::const_iterator it) {
            const double at = axis->values[static_cast<std::size_t>(it - column->values.begin())];
            return fmt::format(" at {:.6g} {}", at, axis->unit);
        };
        data.summary.push_back({"Largest " + label + where(most), *most, column->unit});
        data.summary.push_back({"Least " + label + where(least), *least, column->unit});
    }
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
        data.summary.push_back({"Largest pixel", most, channel.unit});
        data.summary.push_back({"Least pixel", least, channel.unit});
    }
    for (const Quantity quantity : {Quantity::intensity, Quantity::contrastIntensity,
                                    Quantity::irradiance, Quantity::pixels}) {
        const ResultColumn* column = data.table.find(quantity);
        if (column != nullptr && !column->values.empty()) {
            data.summary.push_back(
                {std::string(irsg::info(quantity).label), column->values.front(), column->unit});
        }
    }
}

} // namespace

void summarise(AnalysisData& data) {
    data.summary.clear();
    if (data.kind->form == AnalysisForm::image && !data.image.empty()) {
        addImageNumbers(data);
    } else if (data.kind->form == AnalysisForm::spectrum) {
        addColumnExtremes(data, Quantity::spectralContrastIntensity, Quantity::wavelength);
    } else if (!data.table.empty()) {
        const std::optional<Quantity> abscissa =
            irsg::quantityOfKey(data.table.columns().front().key);
        if (abscissa) {
            addColumnExtremes(data, Quantity::contrastIntensity, *abscissa);
            addColumnExtremes(data, Quantity::irradiance, *abscissa);
        }
    }
}

void writeProvenance(AnalysisData& data, const SceneDescription& scene) {
    Provenance provenance;
    provenance.add("program", "smat " + programVersion());
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
    }
    for (const irsg::Band& band : scene.allBands()) {
        const irsg::SpectralRange range = band.range();
        provenance.add("band",
                       fmt::format("{} ({} to {} um)", band.name(), range.min_um, range.max_um));
    }
    for (const SettingInfo& setting : settingTable()) {
        if (concerns(setting, name(data.kind)) && !data.settings.isDefault(setting.key)) {
            const std::string unit = setting.unit.empty() ? "" : " " + setting.unit;
            provenance.add(setting.key, data.settings.text(setting.key) + unit);
        }
    }
    provenance.add("renderer", data.renderer);
    for (const std::string& answer : data.answeredBy)
        provenance.add("answered by", answer);
    for (const std::string& warning : data.warnings)
        provenance.add("warning", warning);

    // An image carries the same as attributes; what occurs more than once is joined.
    if (!data.image.empty()) {
        for (const auto& [key, value] : provenance.entries) {
            std::string& attribute = data.image.attributes[key];
            attribute += (attribute.empty() ? "" : "; ") + value;
        }
    }
    data.table.provenance = std::move(provenance);
}

} // namespace smat
