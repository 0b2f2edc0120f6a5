#include "smatcore/analysis/SweepTable.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

using irsg::Quantity;

namespace {

/// Of a wavenumber of a spectrum; nothing where its source knows none.
std::optional<irsg::RadiometryErrors> errorsAt(const std::vector<irsg::RadiometryErrors>& errors,
                                               std::size_t i) {
    return errors.empty() ? std::nullopt : std::optional(errors.at(i));
}

} // namespace

SweepTable::SweepTable(const AnalysisPlan& plan, const SceneDescription& scene, ResultTable& table,
                       bool withHorizon)
    : form_(plan.kind->form),
      withSource_(plan.withSource),
      withHorizon_(withHorizon),
      errors_(plan.errors),
      coordinates_(plan.columns),
      bands_({""}),
      partsBy_(plan.parts),
      table_(table) {
    if (scene.entities.size() > 1) {
        for (const irsg::Entity& entity : scene.entities)
            objects_.push_back(entity.name);
        objects_ = distinctLabels(std::move(objects_));
    }
    if (const std::vector<irsg::Band> bands = scene.allBands(); bands.size() > 1)
        bands_ = bandLabels(bands);
    for (const Quantity quantity : plan.columns)
        table_.add(quantity);
    addColumns("");
    for (const std::string& object : objects_) {
        if (form_ != AnalysisForm::spectrum)
            addColumn(Quantity::range, object, "");
        addColumns(object);
    }
    addPartColumns(scene);
    for (std::size_t i = 0; withHorizon_ && i < std::max<std::size_t>(objects_.size(), 1); ++i)
        table_.add(
            ColumnName{"", objects_.empty() ? "" : objects_[i], "hidden_by_horizon", ""}.key(), "");
}

void SweepTable::addColumns(const std::string& object) {
    if (form_ == AnalysisForm::spectrum) {
        const std::vector<Quantity> quantities = {Quantity::spectralIntensity,
                                                  Quantity::spectralContrastIntensity,
                                                  Quantity::spectralIrradiance};
        for (const Quantity quantity : quantities)
            addColumn(quantity, object, "");
        addErrorColumns(quantities, object, "");
        return;
    }
    for (const std::string& band : bands_) {
        for (const Quantity quantity :
             {Quantity::intensity, Quantity::contrastIntensity, Quantity::irradiance}) {
            addColumn(quantity, object, band);
        }
        if (withSource_)
            addColumn(Quantity::sourceIntensity, object, band);
        if (form_ == AnalysisForm::image && object.empty())
            addColumn(Quantity::totalIrradiance, object, band);
        addColumn(Quantity::pixels, object, band);
        std::vector<Quantity> quantities = {Quantity::intensity, Quantity::contrastIntensity,
                                            Quantity::irradiance};
        if (withSource_)
            quantities.push_back(Quantity::sourceIntensity);
        addErrorColumns(quantities, object, band);
    }
}

void SweepTable::addPartColumns(const SceneDescription& scene) {
    for (std::size_t e = 0; partsBy_ != PartsBy::none && e < scene.entities.size(); ++e) {
        parts_.push_back(partsOf(scene.entities[e], partsBy_));
        const std::string object =
            objects_.empty() ? distinctLabels({scene.entities[e].name}).front() : objects_[e];
        for (const ObjectPart& part : parts_.back())
            for (const std::string& band : bands_) {
                for (const Quantity quantity :
                     {Quantity::intensity, Quantity::contrastIntensity, Quantity::irradiance})
                    addColumn(quantity, ColumnName::ofPart(object, part.label), band);
                if (withSource_)
                    addColumn(Quantity::sourceIntensity, ColumnName::ofPart(object, part.label),
                              band);
            }
    }
}

void SweepTable::appendParts(std::vector<double>& row,
                             const std::vector<irsg::RenderReport>& reports) const {
    for (std::size_t e = 0; e < parts_.size(); ++e)
        for (const ObjectPart& part : parts_[e])
            for (std::size_t band = 0; band < bands_.size(); ++band) {
                const irsg::SurfaceRadiometry sum =
                    sumOfPart(reports[band].objects.at(e), partsBy_, part.index);
                row.insert(row.end(),
                           {sum.intensity_W_sr, sum.contrastIntensity_W_sr, sum.irradiance_W_m2});
                if (withSource_)
                    row.push_back(
                        sumOfPart(reports[bands_.size() + band].objects.at(e), partsBy_, part.index)
                            .intensity_W_sr);
            }
}

void SweepTable::addErrorColumns(const std::vector<Quantity>& quantities, const std::string& object,
                                 const std::string& band) {
    for (const Quantity quantity : quantities)
        for (const char* prefix : errorPrefixes(errors_)) {
            const irsg::QuantityInfo& info = irsg::info(quantity);
            table_.add(ColumnName{prefix, object, std::string(info.key), band}.key(),
                       std::string(info.unit));
        }
}

void SweepTable::addErrors(std::vector<double>& row, const irsg::ObjectRadiometry& sums,
                           const irsg::ObjectRadiometry* source) const {
    appendErrors(row, sums.errors, errors_);
    if (source != nullptr)
        appendError(row, source->errors ? source->errors->intensity_W_sr : unknownError(), errors_);
}

void SweepTable::addColumn(Quantity quantity, const std::string& object, const std::string& band) {
    const irsg::QuantityInfo& info = irsg::info(quantity);
    table_.add(ColumnName{"", object, std::string(info.key), band}.key(), std::string(info.unit));
}

void SweepTable::append(std::vector<double>& row, const irsg::ObjectRadiometry& sums,
                        const irsg::ObjectRadiometry* source) {
    row.insert(row.end(), {sums.intensity_W_sr, sums.contrastIntensity_W_sr, sums.irradiance_W_m2});
    if (source != nullptr)
        row.push_back(source->intensity_W_sr);
}

void SweepTable::addCase(const AnalysisCase& one, const std::vector<irsg::RenderReport>& reports,
                         std::string warning) {
    table_.addRow(rowOf(one, reports), std::move(warning));
}

std::vector<double> SweepTable::rowOf(const AnalysisCase& one,
                                      const std::vector<irsg::RenderReport>& reports) const {
    if (reports.size() != bands_.size() * (withSource_ ? 2 : 1))
        throw irsg::LogicError("a row of a sweep needs one report for each band");
    const auto sourceOf = [&](std::size_t band) {
        return withSource_ ? &reports[bands_.size() + band] : nullptr;
    };
    std::vector<double> row;
    for (const Quantity quantity : coordinates_)
        row.push_back(one.value(quantity));
    for (std::size_t band = 0; band < bands_.size(); ++band) {
        const irsg::RenderReport* source = sourceOf(band);
        append(row, reports[band].all, source ? &source->all : nullptr);
        if (form_ == AnalysisForm::image)
            row.push_back(reports[band].totalIrradiance_W_m2);
        row.push_back(reports[band].all.coveredPixels);
        addErrors(row, reports[band].all, source ? &source->all : nullptr);
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        row.push_back(reports.front().objects.at(i).range_m);
        for (std::size_t band = 0; band < bands_.size(); ++band) {
            const irsg::RenderReport* source = sourceOf(band);
            append(row, reports[band].objects.at(i), source ? &source->objects.at(i) : nullptr);
            row.push_back(reports[band].objects.at(i).coveredPixels);
            addErrors(row, reports[band].objects.at(i), source ? &source->objects.at(i) : nullptr);
        }
    }
    appendParts(row, reports);
    for (std::size_t i = 0; withHorizon_ && i < std::max<std::size_t>(objects_.size(), 1); ++i)
        row.push_back(reports.front().objects.at(i).hiddenByHorizon);
    return row;
}

void SweepTable::addSpectrum(const irsg::IntensitySpectrum& spectrum) {
    for (std::size_t i = 0; i < spectrum.wavenumbers_per_cm.size(); ++i) {
        std::vector<double> row = {spectrum.wavenumbers_per_cm[i], spectrum.wavelengths_um[i],
                                   spectrum.intensity_W_sr_um[i],
                                   spectrum.contrastIntensity_W_sr_um[i],
                                   spectrum.irradiance_W_m2_um[i]};
        appendErrors(row, errorsAt(spectrum.errors, i), errors_);
        for (std::size_t e = 0; e < objects_.size(); ++e) {
            const irsg::ObjectSpectrum& object = spectrum.objects.at(e);
            row.insert(row.end(), {object.intensity_W_sr_um[i], object.contrastIntensity_W_sr_um[i],
                                   object.irradiance_W_m2_um[i]});
            appendErrors(row, errorsAt(object.errors, i), errors_);
        }
        table_.addRow(row);
    }
}

} // namespace smat
