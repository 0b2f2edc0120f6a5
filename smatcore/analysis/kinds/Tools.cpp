#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat {

// Tools make tables of their own accord: they are neither planned nor drawn as analyses are.
// Command, menu entry and the kind of their results come from here. A new one is a definition here,
// its name in the list TOOLS of smatcore/CMakeLists.txt, a command and a page
// (gui/tools/ToolPages.cpp).

extern constinit const AnalysisDefinition radiativeTool{
    .name = "radiative",
    .title = "Radiative output",
    .help = "Spectra of the atmosphere: transmittance, radiances, sun and fluxes",
    .icon = "radiative",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition temperatureProfileTool{
    .name = "temperature-profile",
    .title = "Temperature profile",
    .help = "Air temperature over altitude",
    .icon = "thermometer",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition gasTool{
    .name = "gas",
    .title = "Hot gas",
    .help = "Spectrum and band radiance of layers of hot gas, through an atmosphere",
    .icon = "hot-gas",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition monteCarloTool{
    .name = "montecarlo",
    .title = "Monte Carlo",
    .help = "An analysis repeated over the scaling files beside the model",
    .icon = "montecarlo",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition simulationTool{
    .name = "simulate",
    .title = "Simulation",
    .help = "Frames of an engagement: several models, several sensors",
    .icon = "time",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition detectionTool{
    .name = "detection",
    .title = "Detection range",
    .help = "Range at which a sensor detects the target, over one turn or all directions, or "
            "against wind, hour, band or paint",
    .icon = "sensor",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition sensorTool{
    .name = "sensor",
    .title = "Sensor chain",
    .help = "The stages of a sensor: transfer functions, noise, and the picture behind each",
    .icon = "sensor-chain",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition frontierTool{
    .name = "cost-accuracy",
    .title = "Time against error",
    .help = "One view in every mode of antialiasing, atmosphere, background and inter-reflection: "
            "time against error",
    .icon = "frontier",
    .form = AnalysisForm::table,
    .formerName = "frontier"};

extern constinit const AnalysisDefinition otherTable{.name = "other",
                                                     .title = "Table",
                                                     .help =
                                                         "A table of no analysis of this program",
                                                     .icon = "range",
                                                     .form = AnalysisForm::table};

} // namespace smat
