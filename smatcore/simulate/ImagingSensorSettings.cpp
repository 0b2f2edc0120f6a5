#include <fmt/format.h>

#include "irsg/radiometry/Errors.h"
#include "smatcore/simulate/ImagingSensorXml.h"

namespace smat {

ImagingSensorSettings settingsOf(const ImagingSensorParameters& parameters) {
    ImagingSensorSettings result;
    const auto set = [&](const char* key, const std::optional<double>& value) {
        if (value) {
            result.settings.set(key, *value);
        }
    };
    if (parameters.calculationMode) {
        result.settings.set("sensor.mode", *parameters.calculationMode == 2.0 ? "ck" : "spectral");
    }
    set("render.antialiasing", parameters.antialiasingMode);
    if (parameters.useAtmosphereScattering.value_or(0.0) != 0.0) {
        result.warnings.emplace_back(
            "UseAtmosphereScattering is 1, but this version has no aerosol "
            "scattering: frames are made without it");
    }
    return result;
}

ImagingSensorParameters imagingSensorParametersOf(const Settings& settings) {
    ImagingSensorParameters parameters;
    parameters.calculationMode = settings.text("sensor.mode") == "ck" ? 2.0 : 1.0;
    parameters.antialiasingMode = settings.integer("render.antialiasing");
    parameters.useAtmosphereScattering = 0.0;
    return parameters;
}

} // namespace smat
