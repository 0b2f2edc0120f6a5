#include "smatcore/simulate/ScenarioMonteCarlo.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/analysis/MonteCarloReport.h"
#include "smatcore/analysis/RealisationLoop.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/FrameFiles.h"
#include "smatcore/support/Log.h"
#include "smatcore/support/PartialFile.h"

namespace smat {

namespace {

using Views = std::vector<std::unique_ptr<const irsg::ScaledView>>;

double asked(const irsg::ScaledValues& values, MonteCarloOptions::Quantity quantity) {
    return quantity == MonteCarloOptions::Quantity::intensity ? values.intensity.front()
           : quantity == MonteCarloOptions::Quantity::contrastIntensity
               ? values.contrastIntensity.front()
               : values.irradiance.front();
}

/// One run, from the scales to the tables.
class ScenarioRun {
  public:
    ScenarioRun(ScenarioMonteCarlo& run, const RenderDoor& door, const ProgressCallback& progress,
                std::stop_token stop)
        : run_(run),
          door_(door),
          generator_(run.scenario, door),
          progress_(progress),
          stop_(std::move(stop)) {}

    void prepare() {
        run_.options.check();
        if (run_.options.ranking)
            throw monteCarloRefusal("ranking", "asked for", "none: a scenario has no ranking");
        if (run_.options.subpixelShifts != 1)
            throw monteCarloRefusal("subpixel shifts", std::to_string(run_.options.subpixelShifts),
                                    "1: every step of a scenario is at a place of its own");
        generator_.check(run_.plan.sensors, run_.plan.times_s());
        run_.parts.clear();
        run_.warnings.clear();
        const LoadedSensor& first = run_.scenario.sensors.at(run_.plan.sensors.front());
        const Project project = projectOf(run_.scenario.scenario);
        scalings_ = sceneScalings(project, first.scene, run_.warnings);
        seed_ = static_cast<std::uint64_t>(first.settings[key::scalingSeed]);
        std::size_t places = 0;
        for (const std::size_t sensor : run_.plan.sensors)
            places += run_.plan.steps.size() * (run_.scenario.paths.size() + 1) *
                      run_.scenario.sensors[sensor].scene.allBands().size();
        RealisationLoop::check(scalings_, run_.options.samples, places);
        realisations_.emplace(scalings_, run_.options.sequence, seed_);
        total_ = run_.plan.steps.size() * run_.plan.sensors.size() +
                 RealisationLoop::steps(run_.options.samples);
    }

    /// Asks the renderer whether it would draw each step.
    void checkSteps() const {
        bool isAnySeen = false;
        for (const std::size_t sensor : run_.plan.sensors) {
            const SceneDescription& scene = run_.scenario.sensors[sensor].scene;
            static_cast<void>(door_.description(scene));
            for (const SimulationPlan::Step& step : run_.plan.steps) {
                if (!generator_.sees(sensor, step.time_s))
                    continue;
                const PlacedCase placed = generator_.place(sensor, step.time_s).second;
                if (placed.scene.entities.empty())
                    continue;
                door_.check(placed.scene, placed.view, irsg::Outputs::reports(scene.allBands()));
                isAnySeen = true;
            }
        }
        if (!isAnySeen)
            refuseNothingSeen();
    }

    void renderViews() {
        for (const std::size_t sensor : run_.plan.sensors) {
            for (std::size_t entity = 0; entity < run_.scenario.paths.size(); ++entity)
                series_.push_back(seriesOf(sensor, entity));
            if (run_.scenario.paths.size() > 1)
                series_.push_back(seriesOf(sensor, {}));
        }
        for (const SimulationPlan::Step& step : run_.plan.steps) {
            if (!views_.empty() && stop_.stop_requested())
                return;
            for (const std::size_t sensor : run_.plan.sensors) {
                say(fmt::format("{}: {:.6g} s", run_.scenario.scenario.sensors[sensor].name,
                                step.time_s));
                if (generator_.sees(sensor, step.time_s))
                    addViews(sensor, step.time_s);
                ++done_;
            }
            ++steps_;
        }
    }

    void sampleScales() {
        std::vector<MonteCarloData*> parts;
        std::vector<const Series*> series;
        for (Series& one : series_) {
            if (one.data.abscissae.empty()) {
                run_.warnings.push_back(fmt::format("{} is at no step where {} sees it",
                                                    nameOf(one.entity), sensorOf(one)));
                continue;
            }
            for (const std::vector<double>& ofBand : one.nominal)
                one.data.nominal.insert(one.data.nominal.end(), ofBand.begin(), ofBand.end());
            parts.push_back(&one.data);
            series.push_back(&one);
        }
        if (parts.empty())
            refuseNothingSeen();
        RealisationLoop loop(parts, *realisations_, [&](const std::vector<double>& scales) {
            std::vector<double> values;
            irsg::ScaledValues at;
            for (const Series* one : series)
                for (const auto& ofBand : one->views)
                    for (const irsg::ScaledView* view : ofBand) {
                        view->evaluate(scales, at);
                        values.push_back(asked(at, run_.options.quantity));
                    }
            return values;
        });
        loop.run(
            [this](std::size_t draw) {
                say(fmt::format("draw {}", draw));
                ++done_;
            },
            stop_);
        if (steps_ < run_.plan.steps.size())
            run_.warnings.push_back(
                fmt::format("stopped after {} of {} steps", steps_, run_.plan.steps.size()));
        for (MonteCarloData* part : parts)
            part->analysis.warnings = run_.warnings;
        loop.tellShortcomings();
        const bool isDrawn = std::ranges::all_of(parts, [&](const MonteCarloData* part) {
            return part->realisations() == run_.options.samples || part->reachedStandardError;
        });
        run_.state = isDrawn && steps_ == run_.plan.steps.size() ? AnalysisState::complete
                                                                 : AnalysisState::partial;
    }

    void finish() {
        run_.elapsed_s = elapsed_s();
        for (Series& one : series_) {
            if (one.data.abscissae.empty())
                continue;
            ScenarioDistribution part{.sensor = sensorOf(one),
                                      .entity = one.entity ? nameOf(one.entity) : "",
                                      .data = std::move(one.data)};
            AnalysisData& analysis = part.data.analysis;
            analysis.name = part.label();
            analysis.state = run_.state;
            analysis.elapsed_s = run_.elapsed_s;
            Provenance provenance = sensorProvenance(run_.scenario, one.sensor, run_.commandLine);
            provenance.add("seen", part.entity.empty() ? "all entities" : part.entity);
            provenance.add("state", run_.state == AnalysisState::complete ? "complete" : "partial");
            if (run_.scenario.sensors[one.sensor].settings.isDefault(key::scalingSeed))
                provenance.add(key::scalingSeed.name, std::to_string(seed_));
            provenance.add("renderer", door_.description(run_.scenario.sensors[one.sensor].scene));
            for (const std::string& answer : analysis.providedBy)
                provenance.add("answered by", answer);
            for (const std::string& warning : analysis.warnings)
                provenance.add("warning", warning);
            analysis.table.provenance = std::move(provenance);
            reportRealisations(part.data, {irsg::Quantity::time});
            run_.parts.push_back(std::move(part));
        }
        say("done");
    }

  private:
    /// Views of one sensor and one entity; of all together without one.
    struct Series {
        std::size_t sensor = 0;
        std::optional<std::size_t> entity;
        MonteCarloData data;
        std::vector<std::vector<double>> nominal;                ///< by band, then by time
        std::vector<std::vector<const irsg::ScaledView*>> views; ///< the same
    };

    [[noreturn]] static void refuseNothingSeen() {
        throw monteCarloRefusal("steps", "none at which a sensor sees an entity", "at least one");
    }

    Series seriesOf(std::size_t sensor, std::optional<std::size_t> entity) const {
        Series series{.sensor = sensor, .entity = entity, .data = {}, .nominal = {}, .views = {}};
        const std::vector<irsg::Band> bands = run_.scenario.sensors[sensor].scene.allBands();
        series.nominal.resize(bands.size());
        series.views.resize(bands.size());
        series.data.options = run_.options;
        series.data.seed = seed_;
        series.data.scalings = scalings_;
        series.data.bands = bands.size() > 1 ? bandLabels(bands) : std::vector<std::string>{""};
        series.data.analysis.kind = AnalysisKind::simulation;
        series.data.analysis.settings = run_.scenario.sensors[sensor].settings;
        return series;
    }

    void addViews(std::size_t sensor, double time_s) {
        const auto [frame, placed] = generator_.place(sensor, time_s);
        irsg::appendUnique(run_.warnings, frame.warnings);
        // The renderer counts those that are there.
        std::vector<int> renderedOf;
        int drawn = 0;
        for (const auto& at : frame.entities)
            renderedOf.push_back(at ? drawn++ : -1);
        std::vector<irsg::ScalingInput> inputs;
        for (const SceneScaling& scaling : scalings_) {
            inputs.push_back(scaling.input);
            inputs.back().entity = renderedOf[static_cast<std::size_t>(scaling.input.entity)];
        }
        if (drawn == 0)
            return;
        const std::vector<irsg::Band> bands = run_.scenario.sensors[sensor].scene.allBands();
        const std::vector<irsg::RenderReport> reports =
            placed.render(door_, irsg::Outputs::reports(bands).withErrors(false)).reports;
        Views views =
            placed.render(door_, irsg::Outputs::scaledView(inputs, bands).byObject()).scaled;
        const std::size_t perBand = 1 + static_cast<std::size_t>(drawn);
        for (Series& series : series_) {
            if (series.sensor != sensor)
                continue;
            const int place = series.entity ? renderedOf[*series.entity] : 0;
            if (place < 0)
                continue;
            series.data.abscissae.push_back(time_s);
            for (std::size_t band = 0; band < bands.size(); ++band) {
                const auto index = static_cast<std::size_t>(place);
                irsg::appendUnique(series.data.analysis.providedBy, reports[band].providedBy);
                irsg::appendUnique(run_.warnings, reports[band].warnings);
                series.nominal[band].push_back(
                    valueOf(series.entity ? reports[band].objects.at(index) : reports[band].all));
                series.views[band].push_back(
                    views[band * perBand + (series.entity ? 1 + index : 0)].get());
            }
        }
        std::ranges::move(views, std::back_inserter(views_));
    }

    double valueOf(const irsg::ObjectRadiometry& object) const {
        switch (run_.options.quantity) {
        case MonteCarloOptions::Quantity::intensity:
            return object.intensity_W_sr;
        case MonteCarloOptions::Quantity::contrastIntensity:
            return object.contrastIntensity_W_sr;
        case MonteCarloOptions::Quantity::irradiance:
            break;
        }
        return object.irradiance_W_m2;
    }

    std::string nameOf(const std::optional<std::size_t>& entity) const {
        return entity ? run_.scenario.scenario.entities[*entity].name : "no entity";
    }
    const std::string& sensorOf(const Series& series) const {
        return run_.scenario.scenario.sensors[series.sensor].name;
    }
    void say(std::string what) const {
        if (progress_)
            progress_({std::min(done_, total_), total_, elapsed_s(), std::move(what)});
    }
    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    ScenarioMonteCarlo& run_;
    const RenderDoor& door_;
    SceneGenerator3D generator_;
    const ProgressCallback& progress_;
    std::stop_token stop_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    std::vector<SceneScaling> scalings_;
    std::uint64_t seed_ = 1;
    std::optional<ScalingRealisations> realisations_;
    std::vector<Series> series_;
    Views views_; ///< all of them
    std::size_t steps_ = 0, done_ = 0, total_ = 0;
};

std::filesystem::path withLabel(const std::filesystem::path& file, const std::string& label) {
    return file.parent_path() / (file.stem().string() + "-" + label + file.extension().string());
}

} // namespace

void runScenarioMonteCarlo(ScenarioMonteCarlo& asked, const RenderDoor& door,
                           const ProgressCallback& progress, std::stop_token stop,
                           StageTimer* timer) {
    ScenarioRun run(asked, door, progress, std::move(stop));
    run.prepare();
    logInfo("Monte Carlo: drawing the steps");
    {
        const StageTimer::Scope scope(timer, "draw steps");
        run.renderViews();
    }
    logInfo("Monte Carlo: drawing scales");
    {
        const StageTimer::Scope scope(timer, "draw scales");
        run.sampleScales();
    }
    run.finish();
}

void rehearseScenarioMonteCarlo(ScenarioMonteCarlo& asked, const RenderDoor& door) {
    const ProgressCallback none;
    ScenarioRun run(asked, door, none, {});
    run.prepare();
    run.checkSteps();
}

std::vector<std::filesystem::path> distributionFiles(const ScenarioMonteCarlo& run,
                                                     const std::filesystem::path& file) {
    const std::vector<ScenarioEntity>& entities = run.scenario.scenario.entities;
    std::vector<std::filesystem::path> files;
    for (const std::size_t sensor : run.plan.sensors) {
        ScenarioDistribution part{run.scenario.scenario.sensors[sensor].name, "", {}};
        if (entities.size() > 1)
            files.push_back(withLabel(file, part.label()));
        for (const ScenarioEntity& entity : entities) {
            part.entity = entity.name;
            files.push_back(withLabel(file, part.label()));
        }
    }
    return files;
}

std::vector<std::filesystem::path> realisationFiles(const ScenarioMonteCarlo& run,
                                                    const std::filesystem::path& file) {
    std::vector<std::filesystem::path> files;
    files.reserve(run.plan.sensors.size());
    for (const std::size_t sensor : run.plan.sensors)
        files.push_back(withLabel(file, run.scenario.scenario.sensors[sensor].name));
    return files;
}

std::vector<std::filesystem::path> saveDistributions(const ScenarioMonteCarlo& run,
                                                     const std::filesystem::path& file) {
    std::vector<std::filesystem::path> files;
    for (const ScenarioDistribution& part : run.parts) {
        savedResult(withLabel(file, part.label()), run.state == AnalysisState::complete,
                    [&](const std::filesystem::path& place) {
                        const auto made = saveMonteCarlo(part.data, place);
                        files.insert(files.end(), made.begin(), made.end());
                    });
    }
    return files;
}

std::vector<std::filesystem::path> saveScenarioRealisations(const ScenarioMonteCarlo& run,
                                                            const std::filesystem::path& file) {
    std::vector<std::filesystem::path> files;
    for (const std::size_t sensor : run.plan.sensors) {
        const std::string& name = run.scenario.scenario.sensors[sensor].name;
        std::vector<NamedRealisations> parts;
        for (const ScenarioDistribution& part : run.parts)
            if (part.sensor == name)
                parts.push_back({part.entity, &part.data});
        if (parts.empty())
            continue;
        files.push_back(savedResult(
            withLabel(file, name), run.state == AnalysisState::complete,
            [&](const std::filesystem::path& place) { realisationsTable(parts).save(place); }));
    }
    return files;
}

} // namespace smat
