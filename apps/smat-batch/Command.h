#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/project/AnalysisKind.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/support/StageTimer.h"

namespace smat {

class CaseTeam;

} // namespace smat

namespace smat::batch {

enum ExitCode { done = 0, warned = 1, refused = 2, ourFault = 3 };

/// What every command gets from the line it stands on.
struct Context {
    StageTimer timer;          ///< from the start of the process on
    bool json = false;         ///< machine output on standard output
    bool timing = false;       ///< a table of stages on standard error at the end
    bool verbose = false;      ///< log lines on standard error
    std::string commandLine;   ///< as it was given, for the provenance
    std::function<int()> work; ///< what the chosen command does; gives the exit code
    CaseTeam* team = nullptr;  ///< whose processes draw a sweep together; none: this one alone
    std::string speaker;       ///< before an error that is told, where several processes tell
};

/// What is wrong with an option.
inline irsg::InputError refusal(const char* option, std::string value, std::string expected) {
    return irsg::InputError({.file = option,
                             .position = "",
                             .value = std::move(value),
                             .expected = std::move(expected)});
}

/// The same of an option that takes one of some words: with those that are spelt nearly like it.
inline irsg::InputError wordRefusal(const char* option, const std::string& value,
                                    const std::vector<std::string>& words) {
    return refusal(option, value, irsg::alternatives(words) + didYouMean(value, words));
}

/// The option of every command that can be rehearsed.
inline void addDryRun(CLI::App& command, bool& isGiven) {
    command.add_flag("--dry-run", isGiven,
                     "Check all that the run would check before it draws, say what would be drawn, "
                     "and stop");
}

/// Adds the command `name` of `parent`, whose options and work are those of a Work(command,
/// arguments...): it lives as long as the parser.
template <typename Work, typename... Arguments>
void addCommand(CLI::App& parent, Context& context, const std::string& name,
                const std::string& help, const Arguments&... arguments) {
    CLI::App* command = parent.add_subcommand(name, help);
    auto work = std::make_shared<Work>(*command, arguments...);
    command->callback(
        [&context, work] { context.work = [&context, work] { return work->run(context); }; });
}

/// The same of a kind of analysis or tool, which has name and help.
template <typename Work, typename... Arguments>
void addCommand(CLI::App& parent, Context& context, AnalysisKind kind,
                const Arguments&... arguments) {
    addCommand<Work>(parent, context, kind->name, kind->help, arguments...);
}

/// Each adds one command with its options; `context` outlives the parser.
void addRunCommand(CLI::App& app, Context& context);
void addAnalysisCommands(CLI::App& app, Context& context);
void addSweepCommands(CLI::App& app, Context& context); ///< of them those that go case by case
void addDatabaseCommand(CLI::App& app, Context& context);
void addCompareCommand(CLI::App& app, Context& context);
void addConvertCommand(CLI::App& app, Context& context);
void addMergeCommand(CLI::App& app, Context& context);
void addCostAccuracyCommand(CLI::App& app, Context& context);
void addDetectionCommand(CLI::App& app, Context& context);
void addExplainCommand(CLI::App& app, Context& context);
void addGasCommand(CLI::App& app, Context& context);
void addPlumeCommand(CLI::App& app, Context& context);
void addReplayCommand(CLI::App& app, Context& context);
void addModelCommand(CLI::App& app, Context& context);
void addModelCodesCommand(CLI::App& model, Context& context); ///< of `model`
void addMonteCarloCommand(CLI::App& app, Context& context);
void addMtfCommand(CLI::App& app, Context& context);
void addAtmosphereCommand(CLI::App& app, Context& context);
void addSelfTestCommand(CLI::App& app, Context& context);
void addSensorCommand(CLI::App& app, Context& context);
void addSettingsCommand(CLI::App& app, Context& context);
void addProjectCommand(CLI::App& app, Context& context);
void addRadiativeCommand(CLI::App& app, Context& context);
void addSimulateCommand(CLI::App& app, Context& context);
void addTemperatureProfileCommand(CLI::App& app, Context& context);

} // namespace smat::batch
