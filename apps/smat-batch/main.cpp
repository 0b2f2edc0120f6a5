#include "apps/smat-batch/Program.h"

namespace {

void addCommands(CLI::App& app, smat::batch::Context& context) {
    using namespace smat::batch;
    addRunCommand(app, context);
    addAnalysisCommands(app, context);
    addDetectionCommand(app, context);
    addExplainCommand(app, context);
    addCostAccuracyCommand(app, context);
    addReplayCommand(app, context);
    addDatabaseCommand(app, context);
    addCompareCommand(app, context);
    addConvertCommand(app, context);
    addMergeCommand(app, context);
    addModelCommand(app, context);
    addMonteCarloCommand(app, context);
    addMtfCommand(app, context);
    addAtmosphereCommand(app, context);
    addGasCommand(app, context);
    addPlumeCommand(app, context);
    addSelfTestCommand(app, context);
    addSensorCommand(app, context);
    addSettingsCommand(app, context);
    addSimulateCommand(app, context);
    addProjectCommand(app, context);
    addRadiativeCommand(app, context);
    addTemperatureProfileCommand(app, context);
}

} // namespace

int main(int argc, char** argv) {
    smat::batch::Context context;
    return smat::batch::runProgram(
        {"smat-batch", "Infrared signatures from the command line: everything the window does.",
         addCommands},
        argc, argv, context);
}
