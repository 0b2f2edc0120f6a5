#include "apps/smat-batch/Program.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

#include <unistd.h>

#include <fmt/format.h>

#include "apps/UnknownArguments.h"
#include "apps/smat-batch/FormerNames.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/SettingOptions.h"
#include "apps/smat-batch/Streams.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FreedMemory.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
#include "smatcore/data/Provenance.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/support/Log.h"
#include "smatcore/support/ShellText.h"

namespace smat::batch {

namespace {

std::string commandLineOf(const char* program, int argc, char** argv) {
    std::string line = program;
    for (int i = 1; i < argc; ++i)
        line += " " + shellQuoted(argv[i]);
    return line;
}

/// Wall time since the system began to make this process, s, to a tick of its clock (10 ms, as a
/// rule); where it does not say, the processor time so far.
double secondsSinceStart() {
    const double processor_s = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    const auto ticks = static_cast<double>(sysconf(_SC_CLK_TCK));
    timespec now{};
    if (!(ticks > 0.0) || clock_gettime(CLOCK_BOOTTIME, &now) != 0)
        return processor_s;
    try {
        // Behind the name, which may hold anything, the start is the twentieth word.
        const std::string text = irsg::readFile("/proc/self/stat");
        std::istringstream words(text.substr(text.find_last_of(')') + 1));
        std::string word;
        for (int i = 0; i < 20; ++i)
            words >> word;
        const double now_s =
            static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
        if (const std::optional<double> start = irsg::parseNumber(word))
            return std::max(processor_s, now_s - (*start + 0.5) / ticks);
    } catch (const irsg::InputError&) {
        // Another system.
    }
    return processor_s;
}

/// The version with the renderer that would draw, or why there is none.
int printVersion() {
    fmt::print("smat-batch {}\n", irsg::programVersion());
    try {
        fmt::print("renderer: {}\n", openRenderDoor().description(irsg::Scene()));
    } catch (const irsg::InputError& error) {
        fmt::print("renderer: none ({})\n", error.what());
    }
    return done;
}

/// Of the pool and of a software renderer, which reads it when it is started.
void limitThreads(const std::string& text) {
    const std::optional<double> count = irsg::parseNumber(text);
    if (!count || !(*count >= 1.0 && *count <= 1024.0) || *count != std::floor(*count))
        throw refusal("--threads", text, "a whole number from 1 to 1024");
    irsg::setMostThreads(static_cast<unsigned>(*count));
    // 0 draws on the calling thread alone.
    const int drawing = *count > 1.0 ? static_cast<int>(*count) : 0;
    setenv("LP_NUM_THREADS", std::to_string(drawing).c_str(), 1);
}

/// Options that every command takes, before or after its name.
void addCommonOptions(CLI::App& app, Context& context) {
    app.add_flag("--json", context.json, "Machine output on standard output");
    app.add_flag("--timing", context.timing, "A table of the stages and their times at the end");
    app.add_flag("--verbose", context.verbose, "Say what is done, before it is done");
    app.add_option_function<std::string>("--threads", limitThreads,
                                         "Threads that compute, and that draw without a graphics "
                                         "card, at most; as many as there are cores without it")
        ->type_name("N");
    app.add_flag_callback(
        "--version", [&context] { context.work = printVersion; },
        "The version, with the renderer of OpenGL");
    app.fallthrough(); // inherited by the commands, which are added after this
}

/// What commands are written in: names and texts of other encodings would come out broken.
void checkArguments(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (!irsg::isUtf8(argv[i])) {
            throw irsg::InputError(
                irsg::Diagnostic{.file = "argument " + std::to_string(i),
                                 .position = "",
                                 .value = irsg::asciiText(argv[i]) + ", which is not UTF-8",
                                 .expected = "names and texts in UTF-8; a file may be renamed"});
        }
    }
}

int parseAndWork(CLI::App& app, Context& context, int argc, char** argv) {
    checkArguments(argc, argv);
    std::vector<std::string> remarks;
    const std::vector<std::string> arguments =
        withJoinedFlags(withNamesOfToday(app, {argv + 1, argv + argc}, remarks));
    warnOnce(remarks);
    try {
        // As the parser takes them.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        const std::string sentence =
            unknownArgument(app, arguments)
                .value_or(std::string(error.what()) +
                          " (smat-batch COMMAND --help lists the options)");
        tell("error: " + sentence + "\n");
        return refused;
    }
    if (!context.work) {
        tell("error: no command was given, expected one of those below\n\n" + app.help());
        return refused;
    }
    setLogLevel(context.verbose ? LogLevel::info : LogLevel::quiet);
    return context.work();
}

} // namespace

int runProgram(const Program& program, int argc, char** argv, Context& context) {
    openStreams();
    irsg::keepFreedMemory();
    // Before inputs are noted: it reads what is none.
    context.timer.addBefore("start program",
                            std::max(secondsSinceStart() - context.timer.wall_s(), 0.0));
    irsg::protectInputs();
    irsg::setRemarkListener([](const std::string& sentence) { warnOnce({sentence}); });
    context.commandLine = commandLineOf(program.name, argc, argv);
    CLI::App app(program.help, program.name);
    addCommonOptions(app, context);
    program.addCommands(app, context);

    int exitCode = ourFault;
    try {
        exitCode = parseAndWork(app, context, argc, argv);
    } catch (const irsg::InputError& error) {
        complain(error, context.speaker);
        exitCode = refused;
    } catch (const std::filesystem::filesystem_error& error) {
        // The world's fault, where nobody found better words.
        tell("error: " + error.path1().string() + ": found " + error.code().message() +
             ", expected a file or folder that can be used\n");
        exitCode = refused;
    } catch (const std::exception& error) {
        if (!outputFailed()) {
            tell("error: this is a fault of smat-batch itself: " + std::string(error.what()) +
                 "\n");
        }
    }
    if (outputFailed()) {
        tell("error: standard output: found a place that takes no more (" + outputProblem() +
             "), expected room for what is printed\n");
        exitCode = refused;
    }
    if (context.timing) {
        {
            // What the end of the process would take of the time beside the table.
            const StageTimer::Scope scope(&context.timer, "end program");
            irsg::giveBackFreedMemory();
        }
        tell(context.timer.toText());
    }
    return exitCode;
}

} // namespace smat::batch
