#include "apps/smat-batch/AtmosphereArguments.h"
#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "irsg/core/Errors.h"
#include "smatcore/tools/TemperatureProfile.h"

namespace smat::batch {

namespace {

/// `smat-batch temperature-profile ATMOSPHERE... --min m --max m --step m --out FILE.csv`.
class TemperatureProfileCommand {
  public:
    explicit TemperatureProfileCommand(CLI::App& command)
        : air_(command), numbers_(command), files_(command) {
        numbers_.add("--min", "m", "The lowest altitude");
        numbers_.add("--max", "m", "The highest altitude");
        numbers_.add("--step", "m", "From one altitude to the next");
    }

    int run(Context& context) const {
        files_.check("profile.csv", context.json);
        numbers_.check();
        std::vector<irsg::Diagnostic> diagnostics;
        for (const char* option : {"--min", "--max", "--step"})
            if (!numbers_.value(option))
                diagnostics.push_back({option, "", "nothing", "a number of metres"});
        if (!diagnostics.empty())
            throw irsg::InputError(std::move(diagnostics));
        irsg::Environment environment;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            air_.addTo(environment);
        }
        const ResultTable table =
            temperatureProfile(environment, {.min_m = *numbers_.value("--min"),
                                             .max_m = *numbers_.value("--max"),
                                             .step_m = *numbers_.value("--step"),
                                             .commandLine = context.commandLine});
        const StageTimer::Scope scope(&context.timer, "save");
        files_.write(name(AnalysisKind::temperatureProfile), table, {}, {}, context.json);
        return done;
    }

  private:
    AtmosphereArguments air_;
    NumberOptions numbers_;
    TableFiles files_;
};

} // namespace

void addTemperatureProfileCommand(CLI::App& app, Context& context) {
    addCommand<TemperatureProfileCommand>(app, context, AnalysisKind::temperatureProfile);
}

} // namespace smat::batch
