#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/support/Log.h"

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
    const auto set = [&](std::string_view key, const std::optional<double>& value) {
        if (value)
            result.settings.set(key, *value);
    };
    if (parameters.calculationMode) {
        result.settings.set(key::sensorMode,
                            *parameters.calculationMode == 2.0 ? "ck" : "spectral");
    }
    set(key::renderAntialiasing, parameters.antialiasingMode);

    // A uniform background is a grid of one line of sight, whatever its numbers say.
    const bool isUniform = isOn(parameters.isUniformBackground);
    set(key::renderBackgroundRows, isUniform ? 1.0 : parameters.numberOfBackgroundRows);
    set(key::renderBackgroundColumns, isUniform ? 1.0 : parameters.numberOfBackgroundColumns);

    // The file turns pictures on and off; which ones they are stands in the settings.
    const auto turn = [&](const char* parameter, const std::optional<double>& use, PathsKey key,
                          const char* none) {
        if (isOn(use))
            result.needed.push_back({key, parameter});
        else if (use)
            result.settings.set(key, none);
    };
    turn("UseSkyboxBackground", parameters.useSkyboxBackground, key::environmentSkybox, "none");
    turn("UseTerrainBackground", parameters.useTerrainBackground, key::environmentTerrain, "");
    set(key::environmentSkyboxSlope, parameters.skyboxTextureRadianceSlope);
    set(key::environmentSkyboxOffset, parameters.skyboxTextureColorOffset);
    set(key::environmentTerrainSlope, parameters.terrainTextureRadianceSlope);
    set(key::environmentTerrainOffset, parameters.terrainTextureColorOffset);

    if (parameters.useAtmosphereScattering) {
        result.settings.set(key::renderScattering,
                            isOn(parameters.useAtmosphereScattering) ? "true" : "false");
    }
    return result;
}

ImagingSensorParameters imagingSensorParametersOf(const Settings& settings) {
    const int rows = settings[key::renderBackgroundRows];
    const int columns = settings[key::renderBackgroundColumns];
    ImagingSensorParameters parameters;
    parameters.calculationMode = settings.text(key::sensorMode) == "ck" ? 2.0 : 1.0;
    parameters.antialiasingMode = settings[key::renderAntialiasing];
    parameters.isUniformBackground = switchOf(rows == 1 && columns == 1);
    parameters.numberOfBackgroundColumns = columns;
    parameters.numberOfBackgroundRows = rows > 0 ? rows : rowsInPlaceOfAsNeeded;
    parameters.useSkyboxBackground = switchOf(!settings[key::environmentSkybox].empty());
    parameters.useTerrainBackground = switchOf(!settings[key::environmentTerrain].empty());
    parameters.skyboxTextureRadianceSlope = settings[key::environmentSkyboxSlope];
    parameters.skyboxTextureColorOffset = settings[key::environmentSkyboxOffset];
    parameters.terrainTextureRadianceSlope = settings[key::environmentTerrainSlope];
    parameters.terrainTextureColorOffset = settings[key::environmentTerrainOffset];
    parameters.useAtmosphereScattering = switchOf(settings[key::renderScattering]);
    return parameters;
}

std::vector<irsg::Diagnostic> ImagingSensorFile::missingIn(const Settings& inEffect,
                                                           const std::string& whose) const {
    std::vector<irsg::Diagnostic> missing;
    for (const ImagingSensorSettings::Needed& needed : set.needed) {
        if (inEffect[PathsKey{needed.setting.c_str()}].empty()) {
            missing.push_back(
                {.file = file.string(),
                 .position = needed.parameter,
                 .value = "1",
                 .expected = "0, or files in the setting " + needed.setting + " of " + whose});
        }
    }
    return missing;
}

ImagingSensorFile readImagingSensor(const std::filesystem::path& file) {
    logInfo("reading imaging sensor " + file.string());
    const ImagingSensorReading reading = imagingSensorFromKarma(irsg::KarmaXml::read(file));
    ImagingSensorFile read{.file = file, .set = settingsOf(reading.parameters), .remarks = {}};
    for (const std::string& remark : reading.remarks)
        read.remarks.push_back(file.filename().string() + ": " + remark);
    return read;
}

void writeImagingSensor(const Settings& inEffect, const std::filesystem::path& file,
                        const std::filesystem::path& own) {
    const ImagingSensorParameters parameters = imagingSensorParametersOf(inEffect);
    irsg::KarmaXml document = own.empty() ? toKarma(parameters) : irsg::KarmaXml::read(own);
    toKarma(parameters, document);
    document.write(file);
}

} // namespace smat
