#include "smatcore/tools/GasInput.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/support/ShellText.h"
#include "smatcore/tools/GasLayerText.h"

namespace smat {

namespace {

constexpr const char* altitudeOption = "--altitude";
constexpr const char* rangeOption = "--range";
constexpr const char* sensorAltitudeOption = "--sensor-altitude";

} // namespace

std::vector<irsg::Diagnostic> gasPathDiagnostics(const GasInput& input) {
    std::vector<irsg::Diagnostic> diagnostics;
    const bool hasAtmosphere = !input.atmosphere.empty();
    const auto check = [&](const char* option, const std::optional<double>& value_m, bool isNeeded,
                           const char* expected) {
        if (!hasAtmosphere && value_m)
            diagnostics.push_back(
                {option, "", irsg::numberText(*value_m), "nothing without --atmosphere FILE"});
        if (hasAtmosphere && !value_m && isNeeded)
            diagnostics.push_back({option, "", "nothing", "a number of metres with --atmosphere"});
        if (hasAtmosphere && value_m && !(*value_m >= 0.0 && std::isfinite(*value_m)))
            diagnostics.push_back({option, "", irsg::numberText(*value_m), expected});
    };
    const char* const aboveGround = "an altitude of at least 0 m, the ground";
    check(altitudeOption, input.altitude_m, true, aboveGround);
    check(rangeOption, input.range_m, true, "a distance of at least 0 m");
    check(sensorAltitudeOption, input.sensorAltitude_m, false, aboveGround);
    if (!diagnostics.empty() || !hasAtmosphere)
        return diagnostics;
    const double least_m =
        std::abs(input.sensorAltitude_m.value_or(*input.altitude_m) - *input.altitude_m);
    if (*input.range_m < least_m)
        diagnostics.push_back(
            {rangeOption, "", irsg::numberText(*input.range_m),
             "at least the difference of the altitudes, " + irsg::numberText(least_m) + " m"});
    return diagnostics;
}

std::vector<irsg::Diagnostic> gasInputDiagnostics(const GasInput& input) {
    std::vector<irsg::Diagnostic> diagnostics = irsg::gasRequestDiagnostics(input.gas);
    std::vector<irsg::Diagnostic> ofPath = gasPathDiagnostics(input);
    diagnostics.insert(diagnostics.end(), std::make_move_iterator(ofPath.begin()),
                       std::make_move_iterator(ofPath.end()));
    return diagnostics;
}

GasOutputRequest gasOutputRequest(const GasInput& input) {
    if (std::vector<irsg::Diagnostic> diagnostics = gasInputDiagnostics(input);
        !diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    GasOutputRequest request{.gas = input.gas};
    if (input.atmosphere.empty())
        return request;
    request.path = GasPath{.environment = {},
                           .gasAltitude_m = *input.altitude_m,
                           .sensorAltitude_m = input.sensorAltitude_m.value_or(*input.altitude_m),
                           .range_m = *input.range_m};
    addAtmosphere(request.path->environment, input.atmosphere);
    return request;
}

std::string gasCommand(const GasInput& input, const std::string& outputFile) {
    const irsg::GasRequest usual;
    const irsg::GasRequest& gas = input.gas;
    std::string command = "smat-batch gas";
    const auto add = [&](const char* option, const std::optional<double>& value) {
        if (value)
            command += std::string(" ") + option + "=" + irsg::numberText(*value);
    };
    for (const irsg::GasLayer& layer : gas.layers)
        command += " --layer " + gasLayerText(layer);
    command +=
        " --band " + irsg::numberText(gas.band.min_um) + "-" + irsg::numberText(gas.band.max_um);
    if (gas.step_per_cm != usual.step_per_cm)
        add("--step", gas.step_per_cm);
    if (gas.source != usual.source)
        command +=
            std::string(" --source ") + irsg::gasSourceNames[static_cast<std::size_t>(gas.source)];
    add("--background-temperature", gas.background_K);
    for (const std::filesystem::path& file : input.atmosphere)
        command += " --atmosphere " + shellQuoted(file.string());
    add(altitudeOption, input.altitude_m);
    add(rangeOption, input.range_m);
    add(sensorAltitudeOption, input.sensorAltitude_m);
    return command + " --out " + shellQuoted(outputFile);
}

} // namespace smat
