#include "smatcore/analysis/MonteCarlo.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/SceneRestorer.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using irsg::Quantity;
using Asked = MonteCarloOptions::Quantity;

constexpr std::size_t batch = 256;
constexpr std::size_t mostValues = 50'000'000;

irsg::InputError refusal(std::string position, std::string value, std::string expected) {
    return irsg::InputError({.file = "montecarlo",
                             .position = std::move(position),
                             .value = std::move(value),
                             .expected = std::move(expected)});
}

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

double number(const irsg::ObjectRadiometry& all, Asked asked) {
    return asked == Asked::intensity           ? all.intensity_W_sr
           : asked == Asked::contrastIntensity ? all.contrastIntensity_W_sr
                                               : all.irradiance_W_m2;
}

const std::vector<double>& column(const irsg::IntensitySpectrum& spectrum, Asked asked) {
    return asked == Asked::intensity           ? spectrum.intensity_W_sr_um
           : asked == Asked::contrastIntensity ? spectrum.contrastIntensity_W_sr_um
                                               : spectrum.irradiance_W_m2_um;
}

Quantity quantityOf(Asked asked, bool isSpectrum) {
    switch (asked) {
    case Asked::intensity:
        return isSpectrum ? Quantity::spectralIntensity : Quantity::intensity;
    case Asked::contrastIntensity:
        return isSpectrum ? Quantity::spectralContrastIntensity : Quantity::contrastIntensity;
    case Asked::irradiance:
        break;
    }
    return isSpectrum ? Quantity::spectralIrradiance : Quantity::irradiance;
}

void addNew(std::vector<std::string>& sentences, const std::vector<std::string>& more) {
    for (const std::string& sentence : more)
        if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
            sentences.push_back(sentence);
}

/// One run, from the plan to the table.
class Run {
  public:
    Run(ImageSource& source, MonteCarloData& data, const ProgressCallback& progress,
        std::stop_token stop)
        : source_(source), data_(data), progress_(progress), stop_(std::move(stop)) {}

    void load(const SceneFactory& scenes) {
        data_.options.check();
        AnalysisData& analysis = data_.analysis;
        if (analysis.kind == AnalysisKind::image) {
            throw refusal("analysis", analysis.name + ", an image",
                          "a spectrum, polar, time or range analysis");
        }
        analysis.settings.set("scaling.use", "false");
        plan_ = planAnalysis(analysis.kind, analysis.project, analysis.settings);
        isSpectrum_ = analysis.kind == AnalysisKind::spectrum;
        scene_ = scenes(analysis.project, analysis.settings);
        addNew(analysis.warnings, scene_.remarks);
        data_.scalings = sceneScalings(analysis.project, scene_, analysis.warnings);
        const bool anyVaries = std::any_of(data_.scalings.begin(), data_.scalings.end(),
                                           [](const SceneScaling& one) { return !one.isFixed(); });
        if (!anyVaries) {
            throw refusal(
                "scalings", "no scale that varies",
                "a scaling file beside the model with min below max for an index that the "
                "model has");
        }
        const std::size_t places = isSpectrum_ ? plan_.wavenumbers_cm1.size() : plan_.cases.size();
        if (data_.options.samples > mostValues / std::max<std::size_t>(places, 1)) {
            throw refusal("samples",
                          fmt::format("{} at {} abscissae", data_.options.samples, places),
                          fmt::format("at most {} values in all: fewer samples or a coarser sweep",
                                      mostValues));
        }
        const auto seed = static_cast<std::uint64_t>(analysis.settings.integer("scaling.seed"));
        draws_.emplace(data_.scalings, data_.options.sequence, seed);
        if (data_.options.ranking) {
            companions_.emplace(data_.scalings, data_.options.sequence, seed, true);
        }
        for (const SceneScaling& scaling : data_.scalings)
            inputs_.push_back(scaling.input);
        total_ = plan_.cases.size() * static_cast<std::size_t>(data_.options.phases) +
                 (data_.options.samples + batch - 1) / batch + (data_.options.ranking ? 1 : 0);
    }

    void drawViews() {
        AnalysisData& analysis = data_.analysis;
        source_.configure(scene_);
        std::vector<irsg::Vec3> inModel;
        for (std::size_t i = 0; i < scene_.entities.size(); ++i)
            inModel.push_back(source_.referencePointInModel(i));
        analysis.renderer = source_.rendererDescription();
        source_.resetStageTimes();
        const irsg::Pose standing = scene_.entities.front().pose;
        const irsg::Vec3 referencePoint = standing.toWorld(inModel.front());
        const AnalysisCase home =
            planAnalysis(AnalysisKind::image, analysis.project, analysis.settings).cases.front();
        const SceneRestorer restore(source_, scene_, home.viewpoint(referencePoint));

        std::size_t beyondFrame = 0;
        for (const AnalysisCase& one : plan_.cases) {
            if (!views_.empty() && stop_.stop_requested())
                break;
            const irsg::Pose pose = one.pose(standing, inModel.front());
            const irsg::Viewpoint viewpoint = one.viewpoint(referencePoint);
            source_.setPose(0, pose);
            beyondFrame +=
                reachesBeyondFrame(scene_.entities.front(), pose, viewpoint, scene_.sensor) ? 1 : 0;
            for (std::size_t i = 0; i < scene_.entities.size(); ++i) {
                irsg::EntityState state = scene_.entities[i].state;
                state.time_s = one.time_s;
                source_.setState(i, state);
                const irsg::Pose& at = i == 0 ? pose : scene_.entities[i].pose;
                addNew(analysis.warnings, heldTables(scene_.entities[i], state, at,
                                                     at.toWorld(inModel[i]), viewpoint.position_m));
            }
            drawView(one, viewpoint);
        }
        if (beyondFrame > 0)
            analysis.warnings.push_back(fmt::format(
                "the target's bounding box reaches beyond the frame in {} of the cases; "
                "what lies outside is not in the sums",
                beyondFrame));
        allViews_ = views_.size() == plan_.cases.size();
        if (!allViews_)
            analysis.warnings.push_back(
                fmt::format("stopped after {} of {} cases", views_.size(), plan_.cases.size()));
        data_.values.assign(data_.abscissae.size(), {});
    }

    void drawScales() {
        const MonteCarloOptions& options = data_.options;
        for (auto& values : data_.values)
            values.reserve(options.samples);
        std::size_t nextLook = batch;
        while (data_.draws() < options.samples) {
            if (data_.draws() > 0 && stop_.stop_requested())
                break;
            say(fmt::format("draw {}", data_.draws()));
            const std::size_t end = std::min(options.samples, data_.draws() + batch);
            for (std::size_t i = data_.draws(); i < end; ++i) {
                const std::vector<double> all = valuesAt(draws_->at(i));
                for (std::size_t k = 0; k < all.size(); ++k)
                    data_.values[k].push_back(all[k]);
            }
            ++done_;
            // Looked at ever more rarely: each look sorts what there is.
            if (options.standardError && data_.draws() >= nextLook) {
                nextLook = data_.draws() + data_.draws() / 4;
                if (relativeError() <= *options.standardError) {
                    data_.reachedStandardError = true;
                    break;
                }
            }
        }
        data_.statistic = statistics();
        if (options.standardError && !data_.reachedStandardError)
            data_.reachedStandardError = relativeError() <= *options.standardError;
    }

    void rank() {
        if (!companions_)
            return;
        say("ranking");
        std::optional<std::size_t> only;
        if (data_.options.rankingAt)
            only = data_.nearest(*data_.options.rankingAt);
        data_.ranking = rankScalings(
            *companions_, data_.options.sequence, data_.options.rankingPairs,
            [&](const std::vector<double>& scales) {
                std::vector<double> all = valuesAt(scales);
                return only ? std::vector<double>{all[*only]} : all;
            },
            [&](std::size_t pairs) {
                if (pairs % 16 == 0)
                    say(fmt::format("ranking: pair {}", pairs));
                rankedPairs_ = pairs;
                return pairs < 64 || !stop_.stop_requested();
            });
        ++done_;
    }

    void finish() {
        AnalysisData& analysis = data_.analysis;
        const bool isRanked = !companions_ || rankedPairs_ == data_.options.rankingPairs;
        const bool isDrawn = data_.draws() == data_.options.samples || data_.reachedStandardError;
        analysis.state =
            allViews_ && isDrawn && isRanked ? AnalysisState::complete : AnalysisState::partial;
        if (!isDrawn)
            analysis.warnings.push_back(
                fmt::format("stopped after {} of {} draws", data_.draws(), data_.options.samples));
        if (!isRanked)
            analysis.warnings.push_back(fmt::format("stopped after {} of {} pairs of the ranking",
                                                    rankedPairs_, data_.options.rankingPairs));
        if (data_.options.standardError && !data_.reachedStandardError)
            analysis.warnings.push_back(fmt::format(
                "the standard error of the {} is {:.2g} of its largest magnitude after {} draws; "
                "{:.2g} was asked for",
                name(data_.options.statistic), relativeError(), data_.draws(),
                *data_.options.standardError));
        writeTable();
        summarise();
        writeProvenance(analysis, scene_);
        Provenance& provenance = analysis.table.provenance;
        provenance.add("monte carlo", fmt::format("{} draws of the {} sequence, seed {}",
                                                  data_.draws(), name(data_.options.sequence),
                                                  analysis.settings.integer("scaling.seed")));
        provenance.add("quantity", quantityKey());
        provenance.add("standard error of", name(data_.options.statistic));
        provenance.add("phases", std::to_string(data_.options.phases));
        for (const SceneScaling& scaling : data_.scalings)
            provenance.add("scale", describe(scaling));
    }

    void say(std::string what) const {
        if (progress_)
            progress_({std::min(done_, total_), total_, elapsed_s(), std::move(what)});
    }
    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    void drawView(const AnalysisCase& one, const irsg::Viewpoint& viewpoint) {
        AnalysisData& analysis = data_.analysis;
        std::vector<std::vector<double>> atPhases;
        const std::size_t caseNumber = views_.size() + 1;
        for (int phase = 0; phase < data_.options.phases; ++phase) {
            say(fmt::format("case {} of {}, phase {} of {}", caseNumber, plan_.cases.size(),
                            phase + 1, data_.options.phases));
            source_.setViewpoint(phase == 0 ? viewpoint : atPhase(viewpoint, scene_.sensor, phase));
            std::vector<double> values;
            if (isSpectrum_) {
                const irsg::IntensitySpectrum spectrum =
                    source_.measureSpectrum(plan_.wavenumbers_cm1);
                values = column(spectrum, data_.options.quantity);
                if (phase == 0) {
                    data_.abscissae = spectrum.wavelengths_um;
                    addNew(analysis.warnings, spectrum.warnings);
                }
            } else {
                const irsg::RenderReport report = source_.measure();
                values = {number(report.all, data_.options.quantity)};
                if (phase == 0) {
                    data_.abscissae.push_back(one.coordinate);
                    addNew(analysis.answeredBy, report.answeredBy);
                    addNew(analysis.warnings, report.warnings);
                }
            }
            if (phase == 0) {
                views_.push_back(source_.scaledView(inputs_, plan_.wavenumbers_cm1));
                data_.nominal.insert(data_.nominal.end(), values.begin(), values.end());
            }
            atPhases.push_back(std::move(values));
            ++done_;
            if (stop_.stop_requested())
                break;
        }
        for (std::size_t k = 0; k < atPhases.front().size(); ++k) {
            std::vector<double> same;
            for (const auto& values : atPhases)
                same.push_back(values[k]);
            data_.numericalError.push_back(standardDeviationOf(same));
        }
    }

    /// At every abscissa that was drawn.
    std::vector<double> valuesAt(const std::vector<double>& scales) {
        std::vector<double> all;
        all.reserve(data_.abscissae.size());
        for (const auto& view : views_) {
            view->evaluate(scales, scratch_);
            const std::vector<double>& values = column(scratch_, data_.options.quantity);
            all.insert(all.end(), values.begin(), values.end());
        }
        return all;
    }

    std::vector<Estimate> statistics() const {
        std::vector<Estimate> estimates;
        for (const std::vector<double>& values : data_.values)
            estimates.push_back(
                data_.options.sequence == DrawSequence::sobol
                    ? estimateByReplicates(values, sobolReplicates, data_.options.statistic)
                    : estimate(values, data_.options.statistic));
        return estimates;
    }

    /// Largest standard error over the largest magnitude of the statistic.
    double relativeError() const {
        double error = 0.0, magnitude = 0.0;
        for (const Estimate& one : statistics()) {
            error = std::max(error, one.standardError);
            magnitude = std::max(magnitude, std::abs(one.value));
        }
        return error == 0.0 ? 0.0 : error / magnitude;
    }

    std::string quantityKey() const {
        return std::string(irsg::info(quantityOf(data_.options.quantity, isSpectrum_)).key);
    }

    static std::string describe(const SceneScaling& scaling) {
        const irsg::Distribution& d = scaling.distribution;
        std::string text =
            d.isFixed() ? fmt::format("{}: {}", scaling.name, irsg::numberText(d.minimum()))
                        : fmt::format("{}: {}, {} to {}", scaling.name, irsg::info(d.kind()).name,
                                      irsg::numberText(d.minimum()), irsg::numberText(d.maximum()));
        if (!d.hasDefaultParameters())
            for (std::size_t i = 0; i < d.parameters().size(); ++i)
                text += fmt::format(", {} {}", irsg::info(d.kind()).parameters[i],
                                    irsg::numberText(d.parameters()[i]));
        return text;
    }

    void writeTable() {
        ResultTable& table = data_.analysis.table;
        const irsg::QuantityInfo& quantity =
            irsg::info(quantityOf(data_.options.quantity, isSpectrum_));
        const irsg::QuantityInfo& axis =
            irsg::info(isSpectrum_ ? Quantity::wavelength : plan_.coordinate);
        data_.unit = std::string(quantity.unit);
        data_.abscissaKey = std::string(axis.key);
        data_.abscissaUnit = std::string(axis.unit);
        if (isSpectrum_)
            table.add(Quantity::wavenumber);
        table.add(data_.abscissaKey, data_.abscissaUnit);
        for (const char* key :
             {"nominal", "mean", "standard_deviation", "standard_error", "minimum"})
            table.add(key, data_.unit);
        for (const double percent : data_.options.percentiles)
            table.add("p" + irsg::numberText(percent), data_.unit);
        table.add("maximum", data_.unit);
        if (data_.options.phases > 1)
            table.add("error_numerical", data_.unit);
        for (std::size_t k = 0; k < data_.abscissae.size(); ++k) {
            std::vector<double> ascending = data_.values[k];
            std::sort(ascending.begin(), ascending.end());
            std::vector<double> row;
            if (isSpectrum_)
                row.push_back(plan_.wavenumbers_cm1[k]);
            row.insert(row.end(), {data_.abscissae[k], data_.nominal[k], meanOf(ascending),
                                   standardDeviationOf(ascending), data_.statistic[k].standardError,
                                   ascending.front()});
            for (const double percent : data_.options.percentiles)
                row.push_back(percentileOf(ascending, percent));
            row.push_back(ascending.back());
            if (data_.options.phases > 1)
                row.push_back(data_.numericalError[k]);
            table.addRow(row);
        }
    }

    void summarise() {
        std::vector<SummaryItem>& summary = data_.analysis.summary;
        // Where the spread is largest, what it is, and what of it is the drawing's own error.
        std::size_t widest = 0;
        std::vector<double> sigmas;
        for (const std::vector<double>& values : data_.values)
            sigmas.push_back(standardDeviationOf(values));
        widest = static_cast<std::size_t>(std::max_element(sigmas.begin(), sigmas.end()) -
                                          sigmas.begin());
        const std::string where =
            fmt::format(" at {:.6g} {}", data_.abscissae[widest], data_.abscissaUnit);
        const Estimate& estimated = data_.statistic[widest];
        summary.push_back({"Draws", static_cast<double>(data_.draws()), ""});
        summary.push_back({"Largest standard deviation" + where, sigmas[widest], data_.unit});
        summary.push_back({"Mean there", meanOf(data_.values[widest]), data_.unit});
        summary.push_back({"Standard error of the " + name(data_.options.statistic) + " there",
                           estimated.standardError, data_.unit});
        if (data_.options.phases > 1)
            summary.push_back({"Numerical error there", data_.numericalError[widest], data_.unit});
        for (const RankedScaling& one : data_.ranking) {
            if (summary.size() >= 10)
                break;
            summary.push_back({"First-order index of " + data_.scalings[one.scaling].name,
                               one.firstOrder.value, ""});
        }
    }

    ImageSource& source_;
    MonteCarloData& data_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    AnalysisPlan plan_;
    bool isSpectrum_ = false, allViews_ = false;
    SceneDescription scene_;
    std::vector<irsg::ScalingInput> inputs_;
    std::optional<ScalingDraws> draws_, companions_;
    std::vector<std::unique_ptr<const irsg::ScaledView>> views_;
    irsg::ScaledValues scratch_;
    std::size_t done_ = 0, total_ = 0, rankedPairs_ = 0;
};

} // namespace

MonteCarlo::MonteCarlo(ImageSource& source, SceneFactory scenes)
    : source_(source), scenes_(std::move(scenes)) {}

void MonteCarlo::run(MonteCarloData& data, const ProgressCallback& progress, std::stop_token stop,
                     StageTimer* timer) {
    MonteCarloData fresh;
    fresh.analysis = data.analysis;
    fresh.analysis.table = {};
    fresh.analysis.summary.clear();
    fresh.analysis.warnings.clear();
    fresh.analysis.answeredBy.clear();
    fresh.options = data.options;
    Run run(source_, fresh, progress, stop);
    {
        const StageTimer::Scope scope(timer, "load");
        run.load(scenes_);
    }
    logInfo("Monte Carlo: drawing the cases");
    {
        const StageTimer::Scope scope(timer, "draw cases");
        run.drawViews();
    }
    logInfo("Monte Carlo: drawing scales");
    {
        const StageTimer::Scope scope(timer, "draw scales");
        run.drawScales();
    }
    {
        const StageTimer::Scope scope(timer, "rank");
        run.rank();
    }
    fresh.analysis.elapsed_s = run.elapsed_s();
    run.finish();
    run.say("done");
    data = std::move(fresh);
}

} // namespace smat
