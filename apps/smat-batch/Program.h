#pragma once

#include "apps/smat-batch/Command.h"

namespace smat::batch {

/// A program of commands.
struct Program {
    const char* name;
    const char* help;
    void (*addCommands)(CLI::App& app, Context& context);
};

/// Reads the command line and does what it says; what is refused or fails goes to standard error.
/// Returns the exit code.
int runProgram(const Program& program, int argc, char** argv, Context& context);

} // namespace smat::batch
