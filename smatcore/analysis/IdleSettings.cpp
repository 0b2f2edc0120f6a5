#include "smatcore/analysis/IdleSettings.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

bool hasTiles(const Settings& settings) {
    constexpr int firstOfTiles = 3;
    return settings[key::renderAntialiasing] >= firstOfTiles || settings[key::renderTargetError];
}

/// A setting of something else, what that is, and whether it is there.
struct Dependent {
    const char* key;
    const char* of;
    bool (*isThere)(const Settings& settings);
};

const std::vector<Dependent>& dependents() {
    const auto hasSkybox = [](const Settings& s) { return !s[key::environmentSkybox].empty(); };
    const auto hasTerrain = [](const Settings& s) { return !s[key::environmentTerrain].empty(); };
    const auto hasSmartBackground = [](const Settings& s) {
        return s.text(key::renderBackground) == "smart";
    };
    const char* const skybox = "there is no skybox";
    const char* const terrain = "there is no terrain";
    const char* const tiles = "modes 0 to 2 of antialiasing have no tiles";
    const char* const background = "the background is a number, or none";
    static const std::vector<Dependent> all = {
        {key::environmentSkyboxSlope.name, skybox, hasSkybox},
        {key::environmentSkyboxOffset.name, skybox, hasSkybox},
        {key::environmentTerrainSlope.name, terrain, hasTerrain},
        {key::environmentTerrainOffset.name, terrain, hasTerrain},
        {key::environmentTerrainEast.name, terrain, hasTerrain},
        {key::environmentTerrainNorth.name, terrain, hasTerrain},
        {key::environmentTerrainAltitude.name, terrain, hasTerrain},
        {key::renderTerrainHides.name, terrain, hasTerrain},
        {key::environmentScatteringCoefficient.name, "there is no MTF database (environment.mtf)",
         [](const Settings& s) { return !s[key::environmentMtf].empty(); }},
        {key::renderZoom.name, tiles, hasTiles},
        {key::renderPointSource.name, tiles, hasTiles},
        {key::renderHotSpots.name, tiles, hasTiles},
        {key::renderSupersampling.name, "only modes 1 and 2 of antialiasing supersample",
         [](const Settings& s) {
             const int mode = s[key::renderAntialiasing];
             return mode == 1 || mode == 2;
         }},
        {key::renderBackgroundRows.name, background, hasSmartBackground},
        {key::renderBackgroundColumns.name, background, hasSmartBackground},
        {key::renderShadows.name, "reflected sunlight (render.sun) is not smart",
         [](const Settings& s) { return s.text(key::renderSun) == "smart"; }},
        {key::renderFluxWeights.name, "ambient reflection is not smart",
         [](const Settings& s) { return s.text(key::renderAmbientReflection) == "smart"; }},
        {key::renderLightError.name, "there is no inter-reflection (render.bounces)",
         [](const Settings& s) { return s.text(key::renderBounces) != "0"; }},
        {key::renderWidebandError.name, "the calculation mode is spectral",
         [](const Settings& s) { return s.text(key::sensorMode) != "spectral"; }}};
    return all;
}

bool isAmong(const std::string& key, const std::vector<std::string>& keys) {
    return std::ranges::find(keys, key) != keys.end();
}

/// Why a setting has no effect on an analysis; "" where it may have one.
std::string whyIdle(const SettingInfo& setting, const AnalysisData& data, bool drawsScales) {
    const AnalysisKind kind = data.kind;
    const std::string& key = setting.key;
    if (!concerns(setting, name(kind)))
        return fmt::format("it is one of the analysis {} alone", setting.section());
    if (kind->ignored != nullptr && isAmong(setting.key, kind->ignored(data.settings)))
        return "the analysis sets it by itself";
    const bool isImage = kind->form == AnalysisForm::image;
    if (setting.section() == "display" && !isImage)
        return "only images have colours";
    if (key == key::renderParts && kind->form != AnalysisForm::sweep)
        return "only sweeps have columns of parts";
    if (key == key::renderTargetError && kind->form == AnalysisForm::spectrum)
        return "spectra stay as they are set";
    if (key == key::scalingSeed && !drawsScales && !data.settings[key::scalingUse])
        return "scalings (scaling.use) are off";
    const bool isOfSensor = key == key::imageSensorSamples || key == key::imageNoiseSeed;
    if (isOfSensor && data.settings[key::imageSensor].empty())
        return "no sensor (image.sensor) reads the image";
    const auto found =
        std::ranges::find_if(dependents(), [&](const Dependent& one) { return key == one.key; });
    return found != dependents().end() && !found->isThere(data.settings) ? found->of : "";
}

} // namespace

std::vector<std::string> idleSettingRemarks(const AnalysisData& data, bool drawsScales) {
    std::vector<std::string> remarks;
    const Settings& ofProject = data.project.settings;
    for (const SettingInfo& setting : settingTable()) {
        const std::string& text = data.settings.text(setting.key);
        if (text == ofProject.text(setting.key))
            continue;
        if (const std::string why = whyIdle(setting, data, drawsScales); !why.empty())
            remarks.push_back(
                fmt::format("{} = {} has no effect on this analysis: {}", setting.key, text, why));
    }
    const std::string& sensor = ofProject.text(key::imageSensor);
    if (!sensor.empty() && data.kind->form != AnalysisForm::image &&
        data.settings.text(key::imageSensor) == sensor)
        remarks.push_back(
            fmt::format("image.sensor = {} of the project has no effect on this analysis: a sensor "
                        "reads images "
                        "and frames alone, and band and field of view are those of the settings",
                        sensor));
    return remarks;
}

} // namespace smat
