#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "smatcore/support/StageTimer.h"

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
};

/// Each adds one command with its options; `context` outlives the parser.
void addRunCommand(CLI::App& app, Context& context);
void addAnalysisCommands(CLI::App& app, Context& context);
void addDatabaseCommand(CLI::App& app, Context& context);
void addCompareCommand(CLI::App& app, Context& context);
void addConvertCommand(CLI::App& app, Context& context);
void addModelCommand(CLI::App& app, Context& context);
void addMonteCarloCommand(CLI::App& app, Context& context);
void addMtfCommand(CLI::App& app, Context& context);
void addAtmosphereCommand(CLI::App& app, Context& context);
void addSettingsCommand(CLI::App& app, Context& context);
void addRadiativeCommand(CLI::App& app, Context& context);
void addSimulateCommand(CLI::App& app, Context& context);
void addTemperatureProfileCommand(CLI::App& app, Context& context);

} // namespace smat::batch
