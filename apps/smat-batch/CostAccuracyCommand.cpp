#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/RunControl.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/StopSignal.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "smatcore/support/Log.h"

namespace smat::batch {

namespace {

constexpr const char* repeatsOption = "--repeats";
constexpr const char* configurationsOption = "--configurations";

/// `smat-batch cost-accuracy PROJECT [options of the view] --out FILE`.
class CostAccuracyCommand {
  public:
    explicit CostAccuracyCommand(CLI::App& command)
        : project_(command),
          settings_(command, CostAccuracyStudy::kind()),
          numbers_(command),
          files_(command) {
        command
            .add_option(configurationsOption, configurations_,
                        "all, or likely: each choice alone, then those that may be on the front by "
                        "what these showed and a cost model")
            ->type_name("WHICH");
        addDryRun(command, countsOnly_);
        numbers_.add(repeatsOption, "N", "Each time is the least of so many cases, 2 by default");
        command.footer(
            "Columns: the true error of each configuration, the least time of those with "
            "no larger error, its own time, and what it is; smat plot draws them. "
            "--target-error says which one is chosen.");
    }

    int run(Context& context) const {
        if (!countsOnly_ || files_.isGiven())
            files_.check("cost-accuracy.csv", context.json);
        numbers_.check();
        if (configurations_ != "all" && configurations_ != "likely")
            throw wordRefusal(configurationsOption, configurations_, {"all", "likely"});
        CostAccuracyStudy::Options options;
        numbers_.takeWhole(repeatsOption, options.repeats, 1.0, 1000.0);
        options.likely = configurations_ == "likely";
        AnalysisData data;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Settings given = settings_.values();
            data.project = project_.load();
            settings_.place(data.project);
            data.kind = CostAccuracyStudy::kind();
            data.name = name(data.kind);
            data.settings = data.project.settings.with(given);
            data.commandLine = context.commandLine;
        }
        const CostAccuracyStudy::Size size =
            CostAccuracyStudy::sizeOf(data.project, data.settings, options);
        const std::string words =
            options.likely
                ? fmt::format(
                      "{} configurations, {} of which are measured first and then the likely ones: "
                      "about {:.0f} to {:.0f} s",
                      size.all, size.alone, size.least_s, size.most_s)
                : fmt::format("{} configurations: about {:.0f} s", size.all, size.most_s);
        if (countsOnly_) {
            JobRunner().rehearse(data, options);
            files_.checkWritable();
            for (const std::string& warning : data.warnings)
                warn(warning);
            fmt::print("cost-accuracy: {}, with rendering in software\n", words);
            return done;
        }
        logInfo("cost-accuracy: " + words);
        files_.checkWritable();
        catchStopSignal();
        {
            const StageTimer::Scope scope(&context.timer, "measure");
            RunControl control(context);
            JobRunner().run(data, options, files_.checkedOn(control));
        }
        for (const std::string& warning : data.warnings)
            warn(warning);
        const StageTimer::Scope scope(&context.timer, "save");
        const bool isComplete = data.state == AnalysisState::complete;
        files_.write(data.name, data.table, data.summary, {}, context.json, isComplete);
        for (const std::string& sentence : data.providedBy)
            if (!context.json &&
                (sentence.starts_with("configurations: ") || sentence.starts_with("target error")))
                fmt::print("{}\n", sentence);
        return endOfRun(isComplete);
    }

  private:
    ProjectInput project_;
    SettingOptions settings_;
    NumberOptions numbers_;
    TableFiles files_;
    std::string configurations_ = "all";
    bool countsOnly_ = false;
};

} // namespace

void addCostAccuracyCommand(CLI::App& app, Context& context) {
    addCommand<CostAccuracyCommand>(app, context, CostAccuracyStudy::kind());
}

} // namespace smat::batch
