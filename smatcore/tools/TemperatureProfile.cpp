#include "smatcore/tools/TemperatureProfile.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "smatcore/project/AnalysisKind.h"

namespace smat {

namespace {

void check(const TemperatureProfileRequest& request) {
    std::vector<irsg::Diagnostic> diagnostics;
    const auto report = [&](const char* what, double value, std::string expected) {
        diagnostics.push_back(
            {"temperature profile", what, irsg::numberText(value) + " m", std::move(expected)});
    };
    if (!(request.min_m >= 0.0 && std::isfinite(request.min_m)))
        report("min", request.min_m, "a finite altitude of at least 0 m: the ground");
    if (!std::isfinite(request.max_m))
        report("max", request.max_m, "a finite altitude");
    else if (!(request.max_m >= request.min_m) && std::isfinite(request.min_m))
        report("max", request.max_m, "at least min, " + irsg::numberText(request.min_m) + " m");
    if (!(request.step_m > 0.0 && std::isfinite(request.step_m))) {
        report("step", request.step_m, "a finite step above 0 m");
    } else if (!((request.max_m - request.min_m) / request.step_m < maximumProfileRows) &&
               std::isfinite(request.max_m) && std::isfinite(request.min_m)) {
        report("step", request.step_m,
               "a step that gives at most " + std::to_string(maximumProfileRows) + " altitudes");
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

} // namespace

ResultTable temperatureProfile(const irsg::Environment& environment,
                               const TemperatureProfileRequest& request) {
    check(request);
    irsg::Environment air = environment;
    air.defaultAmbient_K.reset();

    // Each altitude from the first, so that roundings do not add up; the last may miss max by one.
    ResultTable table;
    table.add(irsg::Quantity::altitude);
    table.add(irsg::Quantity::temperature);
    const double steps = (request.max_m - request.min_m) / request.step_m;
    const auto rows = static_cast<int>(std::floor(steps * (1.0 + 1e-12))) + 1;
    std::string providedBy;
    for (int i = 0; i < rows; ++i) {
        const double altitude_m =
            std::min(request.min_m + static_cast<double>(i) * request.step_m, request.max_m);
        const irsg::Provided<double> answer = air.ambientTemperature_K(altitude_m);
        providedBy = answer.providedBy;
        table.addRow({altitude_m, answer.value});
    }

    table.provenance.add("program", irsg::programWithVersion());
    table.provenance.add("analysis", name(AnalysisKind::temperatureProfile));
    if (!request.commandLine.empty())
        table.provenance.add("command", request.commandLine);
    table.provenance.add("answered by", "ambient temperature: " + providedBy);
    return table;
}

} // namespace smat
