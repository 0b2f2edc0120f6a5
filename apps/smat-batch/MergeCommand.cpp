#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/FileReading.h"
#include "smatcore/analysis/CaseFile.h"

namespace smat::batch {

namespace {

/// `smat-batch merge PART... --out FILE`.
class MergeCommand {
  public:
    explicit MergeCommand(CLI::App& command) {
        command
            .add_option("PART", parts_,
                        "Files of --shard, FILE.part1of4 and so on, or FILE.cases of a run that "
                        "was ended")
            ->required()
            ->type_name("FILE");
        command.add_option("--out", files_, "Result file; may be given more than once")
            ->required()
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
    }

    int run(Context& context) const {
        AnalysisData data = joinedCases({parts_.begin(), parts_.end()});
        const bool isMonteCarlo = data.kind == AnalysisKind::monteCarlo;
        for (const std::string& file : files_) {
            checkResultFile(data, file);
            if (isMonteCarlo && std::filesystem::path(file).extension() != ".csv")
                throw refusal("--out", file, "a .csv: parts of Monte Carlo have no draws");
        }
        // What is printed names the analysis that was repeated, as that of one run does.
        if (isMonteCarlo)
            data.kind = resultKindFromName(data.table.provenance.value("analysis"));
        Outcome outcome{&data, {}};
        for (const std::string& file : files_) {
            irsg::refuseInputAsOutput(file);
            saveResult(data, file);
            outcome.files.emplace_back(file);
        }
        fmt::print("{}", context.json ? summaryJson({outcome}) : summaryText({outcome}));
        return done;
    }

  private:
    std::vector<std::string> parts_, files_;
};

} // namespace

void addMergeCommand(CLI::App& app, Context& context) {
    addCommand<MergeCommand>(
        app, context, "merge",
        "Joins the parts of a sweep, of Monte Carlo or of a scenario's frames to the "
        "result of one run");
}

} // namespace smat::batch
