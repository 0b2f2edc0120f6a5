#include "smatcore/analysis/MonteCarlo.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/IdleSettings.h"
#include "smatcore/analysis/MonteCarloReport.h"
#include "smatcore/analysis/MonteCarloViews.h"
#include "smatcore/analysis/RealisationLoop.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

/// One run, from the plan to the table.
class Run {
  public:
    Run(const RenderDoor& door, MonteCarloData& data, const ProgressCallback& progress,
        std::stop_token stop)
        : door_(door), data_(data), progress_(progress), stop_(std::move(stop)) {}

    void load(const SceneFactory& scenes) {
        data_.options.check();
        AnalysisData& analysis = data_.analysis;
        if (analysis.kind->form == AnalysisForm::image) {
            throw monteCarloRefusal("analysis", analysis.name + ", an image",
                                    "a spectrum, a sweep or a table");
        }
        analysis.settings = MonteCarlo::settingsOf(analysis);
        plan_ = planAnalysis(analysis.kind, analysis.project, analysis.settings);
        if (!plan_.refined.empty())
            throw monteCarloRefusal(key::stepsOf(name(analysis.kind)), "adaptive",
                                    "fixed, or auto: draws are of the cases that there are before "
                                    "any is drawn");
        if (analysis.kind->form != AnalysisForm::spectrum)
            data_.errors = errorColumnsOf(analysis.settings);
        for (const irsg::Quantity axis : plan_.axes)
            if (axis != plan_.coordinate) {
                const irsg::QuantityInfo& info = irsg::info(axis);
                data_.otherAxes.push_back({std::string(info.key), std::string(info.unit), {}});
            }
        checkRankedPlace();
        scene_ = scenes(analysis.project, analysis.settings);
        scene_.environment = irsg::onTheFly(scene_.environment);
        irsg::appendUnique(analysis.warnings, scene_.remarks);
        irsg::appendUnique(analysis.warnings, idleSettingRemarks(analysis, true));
        data_.scalings = sceneScalings(analysis.project, scene_, analysis.warnings);
        const std::size_t places = plan_.kind->form == AnalysisForm::spectrum
                                       ? plan_.wavenumbers_per_cm.size()
                                       : plan_.cases.size() * scene_.allBands().size();
        RealisationLoop::check(data_.scalings, data_.options.samples, places);
        const auto seed = static_cast<std::uint64_t>(analysis.settings[key::scalingSeed]);
        data_.seed = seed;
        realisations_.emplace(data_.scalings, data_.options.sequence, seed);
        if (data_.options.ranking)
            companions_.emplace(data_.scalings, data_.options.sequence, seed, true);
        total_ = plan_.cases.size() * static_cast<std::size_t>(data_.options.subpixelShifts) +
                 RealisationLoop::steps(data_.options.samples) + (data_.options.ranking ? 1 : 0);
    }

    /// The ranking is at an abscissa that there is: the nearest one within the sweep, which is
    /// told.
    void checkRankedPlace() {
        if (!data_.options.rankingAt)
            return;
        const bool isSpectrum = plan_.kind->form == AnalysisForm::spectrum;
        const irsg::QuantityInfo& axis =
            irsg::info(isSpectrum ? irsg::Quantity::wavelength : plan_.coordinate);
        std::vector<double> places;
        if (isSpectrum)
            for (const double wavenumber_per_cm : plan_.wavenumbers_per_cm)
                places.push_back(irsg::wavelengthFromWavenumber_um(wavenumber_per_cm));
        else
            for (const AnalysisCase& one : plan_.cases)
                places.push_back(one.coordinate);
        const double at = *data_.options.rankingAt;
        const auto [least, most] = std::ranges::minmax(places);
        if (at < least || at > most)
            throw monteCarloRefusal(
                "ranking at", irsg::numberText(at),
                fmt::format("an abscissa from {:.6g} to {:.6g} {}", least, most, axis.unit));
        const double there = places[nearestPlace(places, at)];
        if (!isSpectrum && there != at)
            data_.analysis.warnings.push_back(
                fmt::format("the ranking is of {:.6g} {}, the case that is nearest to {}", there,
                            axis.unit, irsg::numberText(at)));
    }

    void renderViews() {
        views_.emplace(door_, plan_, scene_, data_);
        views_->draw(
            [this](std::string what) {
                say(std::move(what));
                ++done_;
            },
            stop_);
        data_.values.assign(data_.nominal.size(), {});
    }

    void sampleScales() {
        loop_.emplace(
            std::vector<MonteCarloData*>{&data_}, *realisations_,
            [this](const std::vector<double>& scales) { return views_->valuesAt(scales); });
        loop_->run(
            [this](std::size_t draw) {
                say(fmt::format("draw {}", draw));
                ++done_;
            },
            stop_);
    }

    void rank() {
        if (!companions_)
            return;
        say("ranking");
        std::vector<std::size_t> only;
        if (data_.options.rankingAt)
            only = data_.allNearest(*data_.options.rankingAt);
        const auto modelOfPair = [&]() -> ScaledModel {
            const auto memos = std::make_shared<MonteCarloViews::Memos>(views_->memos());
            return [this, only, memos](const std::vector<double>& scales) {
                std::vector<double> all = views_->valuesNear(scales, *memos);
                if (only.empty())
                    return all;
                // That abscissa in every band, at all places of the other axes.
                std::vector<double> chosen;
                for (std::size_t first = 0; first < all.size(); first += data_.abscissae.size())
                    for (const std::size_t row : only)
                        chosen.push_back(all[first + row]);
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

    /// Throws InputError for what has no parts.
    void refuseWhatIsOfAll() const {
        const MonteCarloOptions& options = data_.options;
        if (options.ranking)
            throw monteCarloRefusal("ranking", "a ranking",
                                    "none in parts: it follows from all cases");
        if (options.standardError)
            throw monteCarloRefusal("standard error", "draws that end by it",
                                    "a number of draws alone in parts: it follows from all cases");
        if (data_.analysis.kind->form == AnalysisForm::spectrum)
            throw monteCarloRefusal("analysis", data_.analysis.name + ", a spectrum",
                                    "a sweep: a spectrum is one view, which has no parts");
    }

    /// Looks at all that a run does before it draws; `store` is that of one in parts.
    AnalysisPlan rehearse(CaseStore* store) {
        const CasePlacer placer(door_, scene_);
        if (store == nullptr) {
            data_.analysis.renderer = door_.description(scene_);
        } else {
            beginTable({plan_.coordinate});
            store->rehearse(data_.analysis, plan_.cases.size());
        }
        checkCases(plan_, placer, scene_, door_);
        return plan_;
    }

    /// Case by case into the table.
    void goThrough(CaseStore& store) {
        AnalysisData& analysis = data_.analysis;
        const MonteCarloAxis axis{plan_.coordinate};
        beginTable(axis);
        store.begin(analysis, plan_.cases.size());
        total_ = store.expected(plan_.cases.size());

        AnalysisPlan single = plan_;
        CaseWarnings warnings;
        for (std::size_t i = 0; i < plan_.cases.size(); ++i) {
            std::optional<CaseRecord> drawn;
            const CaseRecord* record = store.known(i);
            if (record != nullptr) {
                warnings.addCase(record->place, record->remarks);
            } else {
                if (!store.isMine(i))
                    continue;
                if (stop_.stop_requested())
                    break;
                single.cases = {plan_.cases[i]};
                drawn = renderedOf(single, axis);
                if (!drawn)
                    break;
                record = &*drawn;
                warnings.addCase(record->place, record->remarks);
                store.add(i, *record);
            }
            analysis.table.addRow(record->row, rowWarning(record->remarks));
            irsg::addProvider(analysis.providedBy, record->providedBy);
            ++done_;
        }
        irsg::appendUnique(analysis.warnings, warnings.sentences());
        if (done_ < total_)
            analysis.warnings.push_back(fmt::format("stopped after {} of {} cases", done_, total_));
        analysis.state =
            done_ == plan_.cases.size() ? AnalysisState::complete : AnalysisState::partial;
        writeProvenance(analysis, scene_);
        tellRealisations(data_, axis, data_.options.samples);
        analysis.summary.push_back({"Draws", static_cast<double>(data_.options.samples), ""});
    }

    /// Of a run in parts: the table without rows, with what is known of it before its first case.
    void beginTable(const MonteCarloAxis& axis) {
        AnalysisData& analysis = data_.analysis;
        analysis.renderer = door_.description(scene_);
        const std::vector<irsg::Band> bands = scene_.allBands();
        data_.bands = bands.size() > 1 ? bandLabels(bands) : std::vector<std::string>{""};
        writeProvenance(analysis, scene_);
        beginRealisations(data_, axis);
    }

    /// The case of a plan, none where a stop was asked for meanwhile.
    std::optional<CaseRecord> renderedOf(const AnalysisPlan& single, const MonteCarloAxis& axis) {
        MonteCarloData one;
        one.analysis.kind = data_.analysis.kind;
        one.analysis.settings = data_.analysis.settings;
        one.options = data_.options;
        one.scalings = data_.scalings;
        one.seed = data_.seed;
        one.errors = data_.errors;
        for (const ResultColumn& axis : data_.otherAxes)
            one.otherAxes.push_back({axis.key, axis.unit, {}});
        const std::string place = single.place(single.cases.front());
        MonteCarloViews views(door_, single, scene_, one);
        views.draw([&](const std::string& what) { say(place + ": " + what); }, stop_);
        if (stop_.stop_requested())
            return std::nullopt;
        RealisationLoop({&one}, *realisations_, [&](const std::vector<double>& scales) {
            return views.valuesAt(scales);
        }).run([&](std::size_t draw) { say(fmt::format("{}: draw {}", place, draw)); }, stop_);
        if (one.realisations() < data_.options.samples)
            return std::nullopt;
        return CaseRecord{place, rowOfRealisations(one, axis, 0), one.analysis.providedBy,
                          views.remarks()};
    }

    void finish() {
        AnalysisData& analysis = data_.analysis;
        const bool isRanked = !companions_ || rankedPairs_ == data_.options.rankingPairs;
        const bool isDrawn =
            data_.realisations() == data_.options.samples || data_.reachedStandardError;
        analysis.state = views_->areAll() && isDrawn && isRanked ? AnalysisState::complete
                                                                 : AnalysisState::partial;
        if (!isRanked)
            analysis.warnings.push_back(fmt::format("stopped after {} of {} pairs of the ranking",
                                                    rankedPairs_, data_.options.rankingPairs));
        loop_->tellShortcomings();
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
    const RenderDoor& door_;
    MonteCarloData& data_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    AnalysisPlan plan_;
    SceneDescription scene_;
    std::optional<ScalingRealisations> realisations_, companions_;
    std::optional<MonteCarloViews> views_;
    std::optional<RealisationLoop> loop_;
    std::size_t done_ = 0, total_ = 0, rankedPairs_ = 0;
};

} // namespace

irsg::InputError monteCarloRefusal(std::string position, std::string value, std::string expected) {
    return irsg::InputError({.file = "montecarlo",
                             .position = std::move(position),
                             .value = std::move(value),
                             .expected = std::move(expected)});
}

MonteCarlo::MonteCarlo(RenderDoor door, SceneFactory scenes)
    : door_(std::move(door)), scenes_(std::move(scenes)) {}

Settings MonteCarlo::settingsOf(const AnalysisData& analysis) {
    Settings settings = withFixedSteps(analysis.kind, analysis.settings);
    settings.set(key::scalingUse, "false");
    return settings;
}

namespace {

/// What is asked, without what came out.
MonteCarloData asked(const MonteCarloData& data) {
    MonteCarloData fresh;
    fresh.analysis = data.analysis;
    fresh.analysis.table = {};
    fresh.analysis.summary.clear();
    fresh.analysis.warnings.clear();
    fresh.analysis.providedBy.clear();
    fresh.options = data.options;
    return fresh;
}

} // namespace

void MonteCarlo::run(MonteCarloData& data, CaseStore& store, const ProgressCallback& progress,
                     std::stop_token stop, StageTimer* timer) {
    MonteCarloData fresh = asked(data);
    fresh.analysis.state = AnalysisState::partial;
    Run run(door_, fresh, progress, stop);
    {
        const StageTimer::Scope scope(timer, "load");
        run.refuseWhatIsOfAll();
        run.load(scenes_);
    }
    logInfo("Monte Carlo: case by case");
    {
        const StageTimer::Scope scope(timer, "draw cases");
        run.goThrough(store);
    }
    fresh.analysis.elapsed_s = run.elapsed_s();
    run.say("done");
    data = std::move(fresh);
}

AnalysisPlan MonteCarlo::rehearse(MonteCarloData& data, CaseStore* store) {
    MonteCarloData fresh = asked(data);
    fresh.analysis.state = store == nullptr ? AnalysisState::notRun : AnalysisState::partial;
    const ProgressCallback none;
    Run run(door_, fresh, none, {});
    if (store != nullptr)
        run.refuseWhatIsOfAll();
    run.load(scenes_);
    AnalysisPlan plan = run.rehearse(store);
    data.analysis.warnings = std::move(fresh.analysis.warnings);
    return plan;
}

void MonteCarlo::run(MonteCarloData& data, const ProgressCallback& progress, std::stop_token stop,
                     StageTimer* timer) {
    MonteCarloData fresh = asked(data);
    Run run(door_, fresh, progress, stop);
    {
        const StageTimer::Scope scope(timer, "load");
        run.load(scenes_);
    }
    logInfo("Monte Carlo: drawing the cases");
    {
        const StageTimer::Scope scope(timer, "draw cases");
        run.renderViews();
    }
    logInfo("Monte Carlo: drawing scales");
    {
        const StageTimer::Scope scope(timer, "draw scales");
        run.sampleScales();
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
