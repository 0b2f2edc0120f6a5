#include "smatcore/analysis/MonteCarloViews.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using irsg::Outputs;
using Asked = MonteCarloOptions::Quantity;

/// Standard deviations that an error is, as those of the renderer (docs/errors.md).
constexpr double deviationsOfError = 2.0;

/// The camera turned by a part of a pixel, another one for every phase.
irsg::Viewpoint atPhase(const irsg::Viewpoint& viewpoint, const irsg::Sensor& sensor, int phase) {
    const double pitch = sensor.pixelPitch();
    const double u = std::fmod(0.7548776662466927 * phase, 1.0) - 0.5;
    const double v = std::fmod(0.5698402909980532 * phase, 1.0) - 0.5;
    const irsg::Vec3 ahead = viewpoint.position_m + viewpoint.forward() +
                             viewpoint.right * (u * pitch) + viewpoint.up * (v * pitch);
    return irsg::Viewpoint::lookAt(viewpoint.position_m, ahead, viewpoint.up, viewpoint.right);
}

const std::vector<double>& column(const irsg::ScaledValues& values, Asked asked) {
    return asked == Asked::intensity           ? values.intensity
           : asked == Asked::contrastIntensity ? values.contrastIntensity
                                               : values.irradiance;
}

double numberOf(const irsg::ObjectRadiometry& all, Asked asked) {
    return asked == Asked::intensity           ? all.intensity_W_sr
           : asked == Asked::contrastIntensity ? all.contrastIntensity_W_sr
                                               : all.irradiance_W_m2;
}

const irsg::ErrorParts& errorOf(const irsg::RadiometryErrors& errors, Asked asked) {
    return asked == Asked::intensity           ? errors.intensity_W_sr
           : asked == Asked::contrastIntensity ? errors.contrastIntensity_W_sr
                                               : errors.irradiance_W_m2;
}

const std::vector<double>& column(const irsg::IntensitySpectrum& spectrum, Asked asked) {
    return asked == Asked::intensity           ? spectrum.intensity_W_sr_um
           : asked == Asked::contrastIntensity ? spectrum.contrastIntensity_W_sr_um
                                               : spectrum.irradiance_W_m2_um;
}

} // namespace

void MonteCarloViews::draw(const Telling& tell, const std::stop_token& stop) {
    AnalysisData& analysis = data_.analysis;
    const CasePlacer placer(door_, scene_);
    analysis.renderer = door_.description(scene_);

    data_.bands = bands_.size() > 1 ? bandLabels(bands_) : std::vector<std::string>{""};
    nominal_.resize(bands_.size());
    numericalError_.resize(bands_.size());
    errors_.resize(bands_.size());
    for (const AnalysisCase& one : plan_.cases) {
        if (!views_.empty() && stop.stop_requested())
            break;
        warnings_.beginCase(plan_.place(one));
        PlacedCase placed = placer.place(scene_, one);
        warnings_.addObjectsBeyondFrame(placed.scene, placed.view);
        for (const std::string& sentence : placed.clampedTables())
            warnings_.add(sentence);
        renderPhases(one, std::move(placed), tell, stop);
        if (plan_.kind->form != AnalysisForm::spectrum)
            data_.caseWarnings.push_back(rowWarning(warnings_.remarks()));
    }
    irsg::appendUnique(analysis.warnings, warnings_.sentences());
    for (std::size_t band = 0; band < bands_.size(); ++band) {
        const auto append = [](auto& all, const auto& more) {
            all.insert(all.end(), more.begin(), more.end());
        };
        append(data_.nominal, nominal_[band]);
        append(data_.numericalError, numericalError_[band]);
        append(data_.nominalErrors, errors_[band]);
    }
    if (!areAll())
        analysis.warnings.push_back(
            fmt::format("stopped after {} of {} cases", views_.size(), plan_.cases.size()));
}

MonteCarloViews::RenderedView MonteCarloViews::renderOne(const AnalysisCase& one,
                                                         const PlacedCase& placed, bool isInPlace) {
    const Asked asked = data_.options.quantity;
    const bool withErrors =
        isInPlace && (data_.errors != ErrorColumns::none || hasNumericalError());
    if (plan_.kind->form == AnalysisForm::spectrum) {
        const irsg::IntensitySpectrum spectrum =
            placed.render(door_, Outputs::spectrum(plan_.wavenumbers_per_cm).withErrors(withErrors))
                .spectrum;
        if (isInPlace)
            for (const std::string& sentence : spectrum.warnings)
                warnings_.add(sentence);
        std::vector<irsg::ErrorParts> errors(spectrum.wavelengths_um.size(), unknownError());
        for (std::size_t k = 0; k < spectrum.errors.size(); ++k)
            errors[k] = errorOf(spectrum.errors[k], asked);
        return {spectrum.wavelengths_um, {column(spectrum, asked)}, {}, {errors}};
    }
    RenderedView drawing{{one.coordinate}, {}, {}, {}};
    const irsg::Rendered rendered =
        placed.render(door_, Outputs::reports(bands_).withErrors(withErrors));
    for (const irsg::RenderReport& report : rendered.reports) {
        drawing.values.push_back({numberOf(report.all, asked)});
        irsg::addProvider(drawing.providedBy, report.providedBy);
        if (isInPlace)
            warnings_.addReport(report, data_.analysis.settings[key::renderLayers]);
        drawing.errors.push_back(
            {report.all.errors ? errorOf(*report.all.errors, asked) : unknownError()});
    }
    return drawing;
}

void MonteCarloViews::renderPhases(const AnalysisCase& one, PlacedCase placed, const Telling& tell,
                                   const std::stop_token& stop) {
    const auto append = [](auto& all, const auto& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    std::vector<RenderedView> atPhases;
    const irsg::Viewpoint viewpoint = placed.view.viewpoint;
    const std::size_t caseNumber = views_.size() + 1;
    for (int phase = 0; phase < data_.options.subpixelShifts; ++phase) {
        tell(fmt::format("case {} of {}, phase {} of {}", caseNumber, plan_.cases.size(), phase + 1,
                         data_.options.subpixelShifts));
        placed.view.viewpoint = phase == 0 ? viewpoint : atPhase(viewpoint, scene_.sensor, phase);
        RenderedView drawing = renderOne(one, placed, phase == 0);
        if (phase == 0) {
            append(data_.abscissae, drawing.abscissae);
            for (ResultColumn& axis : data_.otherAxes)
                axis.values.push_back(one.value(irsg::quantityOfKey(axis.key).value()));
            for (std::size_t band = 0; band < bands_.size(); ++band) {
                append(nominal_[band], drawing.values[band]);
                append(errors_[band], drawing.errors[band]);
            }
            irsg::addProvider(data_.analysis.providedBy, drawing.providedBy);
            std::vector<irsg::ScalingInput> inputs;
            for (const SceneScaling& scaling : data_.scalings)
                inputs.push_back(scaling.input);
            const bool isSpectrum = plan_.kind->form == AnalysisForm::spectrum;
            views_.push_back(placed
                                 .render(door_, isSpectrum ? Outputs::scaledSpectrum(
                                                                 inputs, plan_.wavenumbers_per_cm)
                                                           : Outputs::scaledView(inputs, bands_))
                                 .scaled);
        }
        atPhases.push_back(std::move(drawing));
        if (stop.stop_requested())
            break;
    }
    if (hasNumericalError())
        addNumericalError(atPhases);
}

void MonteCarloViews::addNumericalError(const std::vector<RenderedView>& atPhases) {
    for (std::size_t band = 0; band < bands_.size(); ++band)
        for (std::size_t k = 0; k < atPhases.front().values[band].size(); ++k) {
            std::vector<double> same;
            for (const RenderedView& drawing : atPhases)
                same.push_back(drawing.values[band][k]);
            // What is stated of one drawing, and no less than what its phases show.
            irsg::ErrorParts error = atPhases.front().errors[band][k];
            const double ofPhases = deviationsOfError * standardDeviationOf(same);
            error.sampling = std::max(error.sampling, ofPhases);
            const double sum = error.sum();
            numericalError_[band].push_back(std::isnan(sum) ? ofPhases : sum);
        }
}

std::vector<double> MonteCarloViews::valuesAt(const std::vector<double>& scales) const {
    Memos none(views_.size() * bands_.size());
    return valuesNear(scales, none);
}

MonteCarloViews::Memos MonteCarloViews::memos() const {
    Memos memos;
    for (std::size_t band = 0; band < bands_.size(); ++band)
        for (const auto& ofCase : views_)
            memos.push_back(ofCase[band]->memo());
    return memos;
}

std::vector<double> MonteCarloViews::valuesNear(const std::vector<double>& scales,
                                                Memos& memos) const {
    std::vector<double> all;
    all.reserve(data_.nominal.size());
    irsg::ScaledValues values;
    auto memo = memos.begin();
    for (std::size_t band = 0; band < bands_.size(); ++band)
        for (const auto& ofCase : views_) {
            ofCase[band]->evaluate(scales, values, (memo++)->get());
            const std::vector<double>& chosen = column(values, data_.options.quantity);
            all.insert(all.end(), chosen.begin(), chosen.end());
        }
    return all;
}

} // namespace smat
