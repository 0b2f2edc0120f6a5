#include "smatcore/analysis/MonteCarloViews.h"

#include <cmath>

#include <fmt/format.h>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/NewLines.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/SceneRestorer.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using Asked = MonteCarloOptions::Quantity;

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

irsg::ErrorParts errorOf(const irsg::ObjectRadiometry& all, Asked asked) {
    if (!all.errors)
        return unknownError();
    return asked == Asked::intensity           ? all.errors->intensity_W_sr
           : asked == Asked::contrastIntensity ? all.errors->contrastIntensity_W_sr
                                               : all.errors->irradiance_W_m2;
}

const std::vector<double>& column(const irsg::IntensitySpectrum& spectrum, Asked asked) {
    return asked == Asked::intensity           ? spectrum.intensity_W_sr_um
           : asked == Asked::contrastIntensity ? spectrum.contrastIntensity_W_sr_um
                                               : spectrum.irradiance_W_m2_um;
}

} // namespace

void MonteCarloViews::draw(const Telling& tell, const std::stop_token& stop) {
    AnalysisData& analysis = data_.analysis;
    source_.configure(scene_);
    std::vector<irsg::Vec3> inModel;
    for (std::size_t i = 0; i < scene_.entities.size(); ++i)
        inModel.push_back(source_.referencePointInModel(i));
    analysis.renderer = source_.rendererDescription();
    source_.resetStageTimes();
    const irsg::Pose inScene = scene_.entities.front().pose;
    const irsg::Vec3 referencePoint = inScene.toWorld(inModel.front());
    const SceneRestorer restore(source_, scene_,
                                startingCase(analysis.settings).viewpoint(referencePoint));

    data_.bands = bands_.size() > 1 ? bandLabels(bands_) : std::vector<std::string>{""};
    nominal_.resize(bands_.size());
    numericalError_.resize(bands_.size());
    errors_.resize(bands_.size());
    for (const AnalysisCase& one : plan_.cases) {
        if (!views_.empty() && stop.stop_requested())
            break;
        warnings_.beginCase(plan_.place(one));
        std::vector<irsg::Pose> poses;
        for (const irsg::Entity& entity : scene_.entities)
            poses.push_back(entity.pose);
        const irsg::Pose standing = one.standing(inScene);
        poses.front() = one.pose(standing, inModel.front());
        const irsg::Viewpoint viewpoint = one.viewpoint(standing.toWorld(inModel.front()));
        source_.setPose(0, poses.front());
        warnings_.addObjectsBeyondFrame(scene_, poses, viewpoint);
        for (std::size_t i = 0; i < scene_.entities.size(); ++i) {
            const irsg::EntityState state = one.state(scene_.entities[i].state, scene_.ownOf(i));
            source_.setState(i, state);
            for (const std::string& sentence :
                 clampedTableWarnings(scene_.entities[i], state, poses[i],
                                      poses[i].toWorld(inModel[i]), viewpoint.position_m))
                warnings_.add(sentence);
        }
        drawPhases(one, viewpoint, tell, stop);
    }
    irsg::addNew(analysis.warnings, warnings_.sentences());
    for (std::size_t band = 0; band < bands_.size(); ++band) {
        const auto append = [](std::vector<double>& all, const std::vector<double>& more) {
            all.insert(all.end(), more.begin(), more.end());
        };
        append(data_.nominal, nominal_[band]);
        append(data_.numericalError, numericalError_[band]);
        data_.nominalErrors.insert(data_.nominalErrors.end(), errors_[band].begin(),
                                   errors_[band].end());
    }
    if (!areAll())
        analysis.warnings.push_back(
            fmt::format("stopped after {} of {} cases", views_.size(), plan_.cases.size()));
}

MonteCarloViews::Drawing MonteCarloViews::drawOne(const AnalysisCase& one, bool isInPlace) {
    const Asked asked = data_.options.quantity;
    if (plan_.kind->form == AnalysisForm::spectrum) {
        const irsg::IntensitySpectrum spectrum = source_.measureSpectrum(plan_.wavenumbers_per_cm);
        if (isInPlace)
            for (const std::string& sentence : spectrum.warnings)
                warnings_.add(sentence);
        return {spectrum.wavelengths_um, {column(spectrum, asked)}, {}, {}};
    }
    Drawing drawing{{one.coordinate}, {}, {}, {}};
    const bool withErrors = isInPlace && data_.errors != ErrorColumns::none;
    for (const irsg::RenderReport& report :
         withErrors ? source_.beginMeasure({bands_, false, false, true})()
                    : source_.measure(bands_)) {
        drawing.values.push_back({numberOf(report.all, asked)});
        irsg::addAnswer(drawing.answeredBy, report.answeredBy);
        if (isInPlace)
            warnings_.addReport(report, data_.analysis.settings[key::renderLayers]);
        if (withErrors)
            drawing.errors.push_back(errorOf(report.all, asked));
    }
    return drawing;
}

void MonteCarloViews::drawPhases(const AnalysisCase& one, const irsg::Viewpoint& viewpoint,
                                 const Telling& tell, const std::stop_token& stop) {
    const auto append = [](std::vector<double>& all, const std::vector<double>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    std::vector<Drawing> atPhases;
    const std::size_t caseNumber = views_.size() + 1;
    for (int phase = 0; phase < data_.options.subpixelShifts; ++phase) {
        tell(fmt::format("case {} of {}, phase {} of {}", caseNumber, plan_.cases.size(), phase + 1,
                         data_.options.subpixelShifts));
        source_.setViewpoint(phase == 0 ? viewpoint : atPhase(viewpoint, scene_.sensor, phase));
        Drawing drawing = drawOne(one, phase == 0);
        if (phase == 0) {
            append(data_.abscissae, drawing.abscissae);
            for (std::size_t band = 0; band < bands_.size(); ++band)
                append(nominal_[band], drawing.values[band]);
            for (std::size_t band = 0; band < drawing.errors.size(); ++band)
                errors_[band].push_back(drawing.errors[band]);
            irsg::addAnswer(data_.analysis.answeredBy, drawing.answeredBy);
            std::vector<irsg::ScalingInput> inputs;
            for (const SceneScaling& scaling : data_.scalings)
                inputs.push_back(scaling.input);
            if (plan_.kind->form == AnalysisForm::spectrum)
                views_.emplace_back().push_back(
                    source_.scaledView(inputs, plan_.wavenumbers_per_cm));
            else
                views_.push_back(source_.scaledViews(inputs, bands_));
        }
        atPhases.push_back(std::move(drawing));
        if (stop.stop_requested())
            break;
    }
    addNumericalError(atPhases);
}

void MonteCarloViews::addNumericalError(const std::vector<Drawing>& atPhases) {
    for (std::size_t band = 0; band < bands_.size(); ++band)
        for (std::size_t k = 0; k < atPhases.front().values[band].size(); ++k) {
            std::vector<double> same;
            for (const Drawing& drawing : atPhases)
                same.push_back(drawing.values[band][k]);
            numericalError_[band].push_back(standardDeviationOf(same));
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
