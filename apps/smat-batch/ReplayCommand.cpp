#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/Replay.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::batch {

namespace {

/// `smat-batch replay RESULT [--project FILE] [--previous FILE ...] [--tolerance PART] [--out
/// FILE]`.
class ReplayCommand {
  public:
    explicit ReplayCommand(CLI::App& command) {
        command.add_option("RESULT", file_, "A result that this program wrote")
            ->type_name("FILE")
            ->required();
        command
            .add_option("--previous", previous_,
                        "An input as it was then, known by its content; may be given more than "
                        "once. Tells apart what each of several changes did")
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
        command
            .add_option("--tolerance", tolerance_,
                        "Differences up to this fraction of the largest value of their column are "
                        "none for the exit code; 0")
            ->type_name("PART")
            ->check(CLI::NonNegativeNumber);
        command
            .add_option("--project", project_,
                        "The project of the result, where it lies neither beside it nor in the "
                        "current folder; its name is that which the result tells")
            ->type_name("FILE");
        command.add_option("--out", out_, "Writes the new result, too")->type_name("FILE");
        command.footer("Runs the analysis again with the settings that the result tells, of its "
                       "project beside it, beside its folder of results or in the current folder, "
                       "and says how far the numbers are apart and which input changed. Exits "
                       "with 0 where they are the same, with 1 where they differ.");
    }

    int run(Context& context) const {
        const AnalysisData loaded = loadResult(file_);
        if (!out_.empty())
            checkResultFile(loaded, out_);
        SceneBuilder builder;
        const AnalysisGenerator generator(openRenderDoor(),
                                          [&](const Project& project, const Settings& settings) {
                                              return builder.build(project, settings);
                                          });
        std::optional<Project> project;
        if (!project_.empty())
            project = loadProject(project_);
        ProgressLine progress;
        const Replay again = replay(
            loaded, file_, {previous_.begin(), previous_.end()},
            [&](AnalysisData& data) {
                generator.run(
                    data, [&](const Progress& now) { progress.show(now); }, {}, &context.timer);
            },
            project);
        for (const std::string& remark : again.remarks)
            warn(remark);
        if (!out_.empty())
            saveResult(again.again, out_);
        const std::string shown = std::filesystem::path(file_).filename().string();
        fmt::print("{}\n", context.json ? replayJson(again, shown) : replayText(again, shown));
        return again.mismatches.empty() && again.largestRelative() <= tolerance_ ? done : warned;
    }

  private:
    std::string file_, project_, out_;
    std::vector<std::string> previous_;
    double tolerance_ = 0.0;
};

} // namespace

void addReplayCommand(CLI::App& app, Context& context) {
    addCommand<ReplayCommand>(app, context, "replay",
                              "Runs a result again from what it says of itself, and tells what "
                              "changed");
}

} // namespace smat::batch
