#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/ImageSource.h"
#include "smatcore/data/Provenance.h"
#include "smatcore/support/FreedMemory.h"
#include "smatcore/support/Log.h"

namespace {

using namespace smat;
using namespace smat::batch;

std::string commandLineOf(int argc, char** argv) {
    std::string line = "smat-batch";
    for (int i = 1; i < argc; ++i) {
        line += " " + std::string(argv[i]);
    }
    return line;
}

/// The version with the renderer that would draw, or why there is none.
int printVersion() {
    fmt::print("smat-batch {}\n", programVersion());
    try {
        fmt::print("renderer: {}\n", makeIrsgImageSource()->rendererDescription());
    } catch (const irsg::InputError& error) {
        fmt::print("renderer: none ({})\n", error.what());
    }
    return done;
}

/// Options that every command takes, before or after its name.
void addCommonOptions(CLI::App& app, Context& context) {
    app.add_flag("--json", context.json, "Machine output on standard output");
    app.add_flag("--timing", context.timing, "A table of the stages and their times at the end");
    app.add_flag("--verbose", context.verbose, "Say what is done, before it is done");
    app.add_flag_callback(
        "--version", [&context] { context.work = printVersion; },
        "The version, with the renderer of OpenGL");
    app.fallthrough(); // inherited by the commands, which are added after this
}

} // namespace

int main(int argc, char** argv) {
    keepFreedMemory();
    Context context;
    context.commandLine = commandLineOf(argc, argv);
    CLI::App app("Infrared signatures from the command line: everything the window does.",
                 "smat-batch");
    addCommonOptions(app, context);
    addRunCommand(app, context);
    addAnalysisCommands(app, context);
    addDatabaseCommand(app, context);
    addCompareCommand(app, context);
    addConvertCommand(app, context);
    addModelCommand(app, context);
    addMonteCarloCommand(app, context);
    addMtfCommand(app, context);
    addAtmosphereCommand(app, context);
    addSettingsCommand(app, context);
    addSimulateCommand(app, context);
    addRadiativeCommand(app, context);
    addTemperatureProfileCommand(app, context);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "error: {} (smat-batch COMMAND --help lists the options)\n",
                   error.what());
        return refused;
    }
    if (!context.work) {
        fmt::print(stderr, "error: no command was given, expected one of those below\n\n{}",
                   app.help());
        return refused;
    }

    int exitCode = ourFault;
    setLogLevel(context.verbose ? LogLevel::info : LogLevel::quiet);
    try {
        exitCode = context.work();
    } catch (const irsg::InputError& error) {
        complain(error);
        exitCode = refused;
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: this is a fault of smat-batch itself: {}\n", error.what());
    }
    if (context.timing) {
        fmt::print(stderr, "{}", context.timer.toText());
    }
    return exitCode;
}
