#include "smatcore/simulate/ImagingSensorXml.h"

namespace smat {

namespace {

bool isOn(const std::optional<double>& parameter) {
    return parameter.value_or(0.0) != 0.0;
}

double switchOf(bool isOn) {
    return isOn ? 1.0 : 0.0;
}

/// The file has no word for as many rows as are needed; so many do below 10 km.
constexpr double rowsInPlaceOfAsNeeded = 32.0;

} // namespace

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

    // A uniform background is a grid of one line of sight, whatever its numbers say.
    const bool isUniform = isOn(parameters.isUniformBackground);
    set("render.backgroundRows", isUniform ? 1.0 : parameters.numberOfBackgroundRows);
    set("render.backgroundColumns", isUniform ? 1.0 : parameters.numberOfBackgroundColumns);

    // The file turns pictures on and off; which ones they are stands in the settings.
    const auto turn = [&](const char* parameter, const std::optional<double>& use, const char* key,
                          const char* none) {
        if (isOn(use)) {
            result.needed.push_back({key, parameter});
        } else if (use) {
            result.settings.set(key, none);
        }
    };
    turn("UseSkyboxBackground", parameters.useSkyboxBackground, "environment.skybox", "none");
    turn("UseTerrainBackground", parameters.useTerrainBackground, "environment.terrain", "");
    set("environment.skyboxSlope", parameters.skyboxTextureRadianceSlope);
    set("environment.skyboxOffset", parameters.skyboxTextureColorOffset);
    set("environment.terrainSlope", parameters.terrainTextureRadianceSlope);
    set("environment.terrainOffset", parameters.terrainTextureColorOffset);

    if (parameters.useAtmosphereScattering) {
        result.settings.set("render.scattering",
                            isOn(parameters.useAtmosphereScattering) ? "true" : "false");
    }
    return result;
}

ImagingSensorParameters imagingSensorParametersOf(const Settings& settings) {
    const int rows = settings.integer("render.backgroundRows");
    const int columns = settings.integer("render.backgroundColumns");
    ImagingSensorParameters parameters;
    parameters.calculationMode = settings.text("sensor.mode") == "ck" ? 2.0 : 1.0;
    parameters.antialiasingMode = settings.integer("render.antialiasing");
    parameters.isUniformBackground = switchOf(rows == 1 && columns == 1);
    parameters.numberOfBackgroundColumns = columns;
    parameters.numberOfBackgroundRows = rows > 0 ? rows : rowsInPlaceOfAsNeeded;
    parameters.useSkyboxBackground = switchOf(!settings.paths("environment.skybox").empty());
    parameters.useTerrainBackground = switchOf(!settings.paths("environment.terrain").empty());
    parameters.skyboxTextureRadianceSlope = settings.real("environment.skyboxSlope");
    parameters.skyboxTextureColorOffset = settings.real("environment.skyboxOffset");
    parameters.terrainTextureRadianceSlope = settings.real("environment.terrainSlope");
    parameters.terrainTextureColorOffset = settings.real("environment.terrainOffset");
    parameters.useAtmosphereScattering = switchOf(settings.boolean("render.scattering"));
    return parameters;
}

} // namespace smat
