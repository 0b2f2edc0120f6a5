#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PartOptions.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/ScenarioOptions.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/jobs/CaseTeam.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::batch {

namespace {

/// `smat-batch montecarlo PROJECT --samples N --seed S --out FILE`.
class MonteCarloCommand {
  public:
    explicit MonteCarloCommand(CLI::App& command)
        : command_(command),
          project_(command),
          settings_(command,
                    [](const SettingInfo& setting) {
                        return !isAnalysisSection(setting.section()) &&
                               setting.key != key::scalingUse;
                    }),
          numbers_(command),
          parts_(command, "the sweep that is repeated") {
        settings_.takeModels();
        command
            .add_option("--out", files_, "Result file, .csv or .json; may be given more than once")
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
        command
            .add_option("--draws", realisationFiles_,
                        "Raw draws, a row each with its scales and the quantity at every abscissa, "
                        ".csv or .json; may be given more than once")
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
        command
            .add_option("--analysis", analysis_,
                        "Analysis of the project that is repeated; the first that is no image "
                        "without it")
            ->type_name("NAME");
        command
            .add_option("--kind", kind_,
                        kindsText() + " with the project's own settings, in place of --analysis")
            ->type_name("WORD");
        numbers_.add("--samples", "N", "Draws at most, 1024 by default");
        command.add_option("--sequence", sequence_, "sobol (default) or plain draws")
            ->type_name("WORD");
        command
            .add_option("--quantity", quantity_,
                        "contrast_intensity (default), intensity or irradiance")
            ->type_name("WORD");
        command
            .add_option("--statistic", statistic_,
                        "What the standard error is of: mean (default), standard-deviation, or a "
                        "percentile such as p95")
            ->type_name("WORD");
        numbers_.add("--standard-error", "X",
                     "Stops when the statistic's standard error is below this part of its largest "
                     "magnitude");
        command
            .add_option("--percentiles", percentiles_,
                        "Percentiles of the bands, 5,25,50,75,95 by default")
            ->type_name("LIST");
        numbers_.add(
            "--subpixel-shifts", "N",
            "Drawings of each case that tell the numerical error, 4 by default; 1 for none");
        command.add_flag("--ranking", ranking_,
                         "Ranks the scales by their first-order Sobol' indices");
        numbers_.add("--ranking-pairs", "N", "Pairs of draws of the ranking, 1024 by default");
        numbers_.add("--ranking-at", "X",
                     "Abscissa the ranking looks at (wavelength in um for a spectrum), all rows "
                     "there; the whole "
                     "sweep without it");
        command
            .add_option("--sensor", sensors_,
                        "Of a scenario: only this one; may be given more than once")
            ->type_name("NAME")
            ->expected(1)
            ->take_all();
        numbers_.add("--from", "s", "Of a scenario: time of the first step");
        numbers_.add("--to", "s", "Of a scenario: time of the last step");
        addDryRun(command, dryRun_);
        command.footer(
            "In place of a project a scenario (JSON): what each sensor sees of each entity at each "
            "of its steps, in FILE-SENSOR-ENTITY.csv; of all entities together in FILE-SENSOR.csv. "
            "Raw draws go to FILE-SENSOR.csv.");
    }

    int run(Context& context) const {
        checkFiles(context);
        if (isScenarioFile(project_.file()))
            return runScenario(context);
        refuseGiven({"--sensor", "--from", "--to"}, "a scenario in place of a project");
        JobRunner runner;
        MonteCarloJob job{.files = {files_.begin(), files_.end()},
                          .realisationFiles = {realisationFiles_.begin(), realisationFiles_.end()},
                          .share = parts_.share(),
                          .isInParts = parts_.isGiven(),
                          .resumes = parts_.resumes()};
        AnalysisData& analysis = job.data.analysis;
        job.data.options = options();
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Settings given = settings_.values();
            Project project = project_.load();
            settings_.place(project);
            analysis = started(project);
            analysis.settings = analysis.settings.with(given);
            analysis.commandLine = context.commandLine;
            settings_.requireNamed(analysis.settings);
        }
        if (dryRun_) {
            const AnalysisPlan plan = runner.rehearse(job, context.team != nullptr);
            if (context.team == nullptr || context.team->isLeader())
                describe(job.data, plan, context);
            return done;
        }
        catchStopSignal();
        const JobOutcome outcome = runner.run(job, RunControl(context));
        if (!outcome.isLed)
            return done;
        warnOf(outcome);
        for (const std::string& warning : analysis.warnings)
            warn(analysis.name + ": " + warning);
        report({{&analysis, outcome.files}}, context);
        const bool isComplete = analysis.state == AnalysisState::complete;
        const int end = endOfRun(isComplete);
        return isComplete || job.isInParts ? end : warned;
    }

  private:
    /// All kinds of analyses but images.
    static std::vector<std::string> kinds() {
        std::vector<std::string> words;
        for (const AnalysisKind kind : allAnalysisKinds())
            if (kind->form != AnalysisForm::image)
                words.push_back(name(kind));
        return words;
    }
    static std::string kindsText() { return irsg::alternatives(kinds()); }

    static void report(const std::vector<Outcome>& outcomes, const Context& context) {
        fmt::print("{}", context.json ? summaryJson(outcomes) : summaryText(outcomes));
    }

    static void describe(const MonteCarloData& data, const AnalysisPlan& plan,
                         const Context& context) {
        for (const std::string& warning : data.analysis.warnings)
            warn(data.analysis.name + ": " + warning);
        if (!context.json) {
            fmt::print("{}: {}, at most {} draws\n", data.analysis.name, plan.description,
                       data.options.samples);
            return;
        }
        const nlohmann::ordered_json one{{"name", data.analysis.name},
                                         {"kind", name(plan.kind)},
                                         {"cases", plan.cases.size()},
                                         {"description", plan.description},
                                         {"draws", data.options.samples}};
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"plans", {one}}}));
    }

    static void describe(const ScenarioMonteCarlo& run, const Context& context) {
        for (const std::string& warning : run.warnings)
            warn(warning);
        auto list = nlohmann::ordered_json::array();
        for (const std::size_t sensor : run.plan.sensors) {
            const std::string& name = run.scenario.scenario.sensors[sensor].name;
            const auto &first = run.plan.steps.front(), &last = run.plan.steps.back();
            list.push_back({{"sensor", name},
                            {"steps", run.plan.steps.size()},
                            {"from_s", first.time_s},
                            {"to_s", last.time_s},
                            {"draws", run.options.samples}});
            if (!context.json)
                fmt::print("{}: {} steps from {:g} to {:g} s, at most {} draws\n", name,
                           run.plan.steps.size(), first.time_s, last.time_s, run.options.samples);
        }
        if (context.json)
            fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"plans", list}}));
    }

    void refuseGiven(const std::vector<const char*>& options, const std::string& expected) const {
        for (const char* option : options)
            if (command_.get_option(option)->count() > 0)
                throw refusal(option, "an option", expected);
    }

    int runScenario(Context& context) const {
        refuseGiven({"--analysis", "--kind", "--ranking", "--ranking-pairs", "--ranking-at"},
                    "a project in place of a scenario");
        project_.refuseOptionsFor("a scenario");
        parts_.refuse("a project in place of a scenario");
        if (context.team != nullptr)
            throw refusal("montecarlo", "a scenario", "a project for several processes");
        JobRunner runner;
        ScenarioMonteCarloJob job{
            .files = {files_.begin(), files_.end()},
            .realisationFiles = {realisationFiles_.begin(), realisationFiles_.end()}};
        ScenarioMonteCarlo& run = job.run;
        run.options = options();
        if (!numbers_.value("--subpixel-shifts"))
            run.options.subpixelShifts = 1;
        run.commandLine = context.commandLine;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            Settings given = scenarioOverrides(settings_);
            given.set(key::scalingUse, "false");
            const Scenario scenario = openScenario(project_.file());
            run.plan = planSimulation(scenario, {.sensors = sensors_,
                                                 .from_s = numbers_.value("--from"),
                                                 .to_s = numbers_.value("--to")});
            run.scenario = loadScenarioFiles(scenario, runner.scenes(), given);
            for (const std::size_t sensor : run.plan.sensors) {
                settings_.requireNamed(run.scenario.sensors[sensor].settings);
                for (const std::string& warning : run.scenario.sensors[sensor].warnings)
                    warn(scenario.sensors[sensor].name + ": " + warning);
            }
        }
        if (dryRun_) {
            runner.rehearse(job);
            describe(run, context);
            return done;
        }
        catchStopSignal();
        const JobOutcome outcome = runner.run(job, RunControl(context));
        for (const std::string& warning : run.warnings)
            warn(warning);
        std::vector<Outcome> outcomes;
        for (const ScenarioDistribution& part : run.parts)
            outcomes.push_back({&part.data.analysis, {}});
        outcomes.back().files = outcome.files;
        report(outcomes, context);
        const bool isComplete = run.state == AnalysisState::complete;
        const int end = endOfRun(isComplete);
        return isComplete ? end : warned;
    }

    void checkFiles(const Context& context) const {
        // What is gone on with lies beside a result.
        const bool needsFile = !dryRun_ || parts_.isGiven() || context.team != nullptr;
        if (needsFile && files_.empty() && realisationFiles_.empty())
            throw refusal("--out", "nothing", "a result file, such as --out montecarlo.csv");
        const auto check = [](const char* option, const std::vector<std::string>& files) {
            for (const std::string& file : files) {
                const std::string extension = std::filesystem::path(file).extension().string();
                if (extension != ".csv" && extension != ".json")
                    throw refusal(option, file, "a file that ends in .csv or .json");
            }
        };
        check("--out", files_);
        check("--draws", realisationFiles_);
    }

    AnalysisData started(const Project& project) const {
        if (!kind_.empty()) {
            const auto kind = analysisKindFromName(kind_);
            if (!kind || (*kind)->form == AnalysisForm::image)
                throw wordRefusal("--kind", kind_, kinds());
            if (!analysis_.empty())
                throw refusal("--kind", kind_, "nothing beside --analysis");
            return AnalysisData::of(project, *kind);
        }
        if (!analysis_.empty())
            return AnalysisData::of(project, analysis_);
        for (const NamedAnalysis& analysis : project.analyses)
            if (analysis.kind->form != AnalysisForm::image)
                return AnalysisData::of(project, analysis.name);
        return AnalysisData::of(project, AnalysisKind::polar);
    }

    MonteCarloOptions options() const {
        numbers_.check();
        MonteCarloOptions options;
        numbers_.takeWhole("--samples", options.samples);
        numbers_.takeWhole("--subpixel-shifts", options.subpixelShifts);
        numbers_.takeWhole("--ranking-pairs", options.rankingPairs);
        options.standardError = numbers_.value("--standard-error");
        options.rankingAt = numbers_.value("--ranking-at");
        options.ranking = ranking_ || options.rankingAt || numbers_.value("--ranking-pairs");
        if (sequence_ != "sobol" && sequence_ != "plain")
            throw wordRefusal("--sequence", sequence_, {"sobol", "plain"});
        options.sequence =
            sequence_ == "plain" ? RealisationSequence::plain : RealisationSequence::sobol;
        const auto quantity = monteCarloQuantity(quantity_);
        if (!quantity)
            throw wordRefusal("--quantity", quantity_,
                              {"contrast_intensity", "intensity", "irradiance"});
        options.quantity = *quantity;
        const auto statistic = statisticFromName(statistic_);
        if (!statistic) {
            throw refusal("--statistic", statistic_,
                          "mean, standard-deviation, or a percentile such as p95");
        }
        options.statistic = *statistic;
        if (!percentiles_.empty()) {
            options.percentiles.clear();
            for (std::size_t at = 0; at <= percentiles_.size();) {
                const std::size_t comma = std::min(percentiles_.find(',', at), percentiles_.size());
                const std::string word = percentiles_.substr(at, comma - at);
                const auto percent = irsg::parseNumber(word);
                if (!percent)
                    throw refusal("--percentiles", word, "numbers separated by commas");
                options.percentiles.push_back(*percent);
                at = comma + 1;
            }
        }
        return options;
    }

    CLI::App& command_;
    ProjectInput project_;
    SettingOptions settings_;
    NumberOptions numbers_;
    PartOptions parts_;
    std::vector<std::string> files_, realisationFiles_, sensors_;
    std::string analysis_, kind_, sequence_ = "sobol", quantity_ = "contrast_intensity",
                                  statistic_ = "mean", percentiles_;
    bool ranking_ = false, dryRun_ = false;
};

} // namespace

void addMonteCarloCommand(CLI::App& app, Context& context) {
    addCommand<MonteCarloCommand>(app, context, AnalysisKind::monteCarlo);
}

} // namespace smat::batch
