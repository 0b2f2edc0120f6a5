#include "smatcore/analysis/MonteCarlo.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/NewLines.h"
#include "irsg/radiometry/ParallelFor.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/MonteCarloReport.h"
#include "smatcore/analysis/MonteCarloViews.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

constexpr std::size_t batch = 256;
constexpr std::size_t mostValues = 50'000'000;

irsg::InputError refusal(std::string position, std::string value, std::string expected) {
    return irsg::InputError({.file = "montecarlo",
                             .position = std::move(position),
                             .value = std::move(value),
                             .expected = std::move(expected)});
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
        if (analysis.kind->form == AnalysisForm::image) {
            throw refusal("analysis", analysis.name + ", an image",
                          "a spectrum, polar, time or range analysis");
        }
        analysis.settings.set(key::scalingUse, "false");
        plan_ = planAnalysis(analysis.kind, analysis.project, analysis.settings);
        scene_ = scenes(analysis.project, analysis.settings);
        irsg::addNew(analysis.warnings, scene_.remarks);
        data_.scalings = sceneScalings(analysis.project, scene_, analysis.warnings);
        const bool anyVaries = std::any_of(data_.scalings.begin(), data_.scalings.end(),
                                           [](const SceneScaling& one) { return !one.isFixed(); });
        if (!anyVaries) {
            throw refusal(
                "scalings", "no scale that varies",
                "a scaling file beside the model with min below max for an index that the "
                "model has");
        }
        const std::size_t places = plan_.kind->form == AnalysisForm::spectrum
                                       ? plan_.wavenumbers_per_cm.size()
                                       : plan_.cases.size() * scene_.allBands().size();
        if (data_.options.samples > mostValues / std::max<std::size_t>(places, 1)) {
            throw refusal("samples",
                          fmt::format("{} at {} abscissae", data_.options.samples, places),
                          fmt::format("at most {} values in all: fewer samples or a coarser sweep",
                                      mostValues));
        }
        const auto seed = static_cast<std::uint64_t>(analysis.settings[key::scalingSeed]);
        draws_.emplace(data_.scalings, data_.options.sequence, seed);
        if (data_.options.ranking)
            companions_.emplace(data_.scalings, data_.options.sequence, seed, true);
        total_ = plan_.cases.size() * static_cast<std::size_t>(data_.options.phases) +
                 (data_.options.samples + batch - 1) / batch + (data_.options.ranking ? 1 : 0);
    }

    void drawViews() {
        views_.emplace(source_, plan_, scene_, data_);
        views_->draw(
            [this](std::string what) {
                say(std::move(what));
                ++done_;
            },
            stop_);
        data_.values.assign(data_.nominal.size(), {});
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
            std::vector<std::vector<double>> drawn(end - data_.draws());
            irsg::parallelFor(drawn.size(), [&](std::size_t i) {
                drawn[i] = views_->valuesAt(draws_->at(data_.draws() + i));
            });
            for (const std::vector<double>& all : drawn)
                for (std::size_t k = 0; k < all.size(); ++k)
                    data_.values[k].push_back(all[k]);
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
        const auto modelOfPair = [&]() -> ScaledModel {
            const auto memos = std::make_shared<MonteCarloViews::Memos>(views_->memos());
            return [this, only, memos](const std::vector<double>& scales) {
                std::vector<double> all = views_->valuesNear(scales, *memos);
                if (!only)
                    return all;
                // That abscissa in every band.
                std::vector<double> chosen;
                for (std::size_t k = *only; k < all.size(); k += data_.abscissae.size())
                    chosen.push_back(all[k]);
                return chosen;
            };
        };
        data_.ranking =
            rankScalings(*companions_, data_.options.sequence, data_.options.rankingPairs,
                         modelOfPair, [&](std::size_t pairs) {
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
        analysis.state = views_->areAll() && isDrawn && isRanked ? AnalysisState::complete
                                                                 : AnalysisState::partial;
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
        reportMonteCarlo(data_, plan_, scene_);
    }

    void say(std::string what) const {
        if (progress_)
            progress_({std::min(done_, total_), total_, elapsed_s(), std::move(what)});
    }
    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
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

    ImageSource& source_;
    MonteCarloData& data_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    AnalysisPlan plan_;
    SceneDescription scene_;
    std::optional<ScalingDraws> draws_, companions_;
    std::optional<MonteCarloViews> views_;
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
