#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/atmosphere/SolarPosition.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileStamp.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/RenderWords.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// The sun of an Environment file, or that of the defaults, moved to where the settings put it.
irsg::SunPosition sunFrom(const Settings& settings, const std::optional<irsg::SunPosition>& file) {
    irsg::SunPosition sun{.azimuth_rad = file ? file->azimuth_rad
                                              : irsg::radians(settings[key::environmentSunAzimuth]),
                          .elevation_rad =
                              file ? file->elevation_rad
                                   : irsg::radians(settings[key::environmentSunElevation])};
    if (const auto day = settings[key::environmentDayOfYear])
        sun.distance_au = irsg::sunDistance_au(static_cast<int>(*day));
    moveSun(sun, settings);
    return sun;
}

/// The one band of settings that have one.
irsg::Band bandOf(const Project& project, const Settings& settings) {
    const auto response = settings[key::sensorResponse];
    return response.empty() ? irsg::Band::fromText(settings.text(key::sensorBand))
                            : irsg::Band::fromCsv(project.resolve(response.front()));
}

} // namespace

void moveSun(irsg::SunPosition& sun, const Settings& settings) {
    if (settings.isSet(key::environmentSunAzimuth))
        sun.azimuth_rad = irsg::radians(settings[key::environmentSunAzimuth]);
    if (settings.isSet(key::environmentSunElevation))
        sun.elevation_rad = irsg::radians(settings[key::environmentSunElevation]);
}

irsg::SunPosition sunOf(const Project& project, const Settings& settings) {
    std::optional<irsg::SunPosition> ofFile;
    for (const std::filesystem::path& listed : settings[key::environmentAtmospheres]) {
        const auto file = project.resolve(listed);
        if (ofFile || isNoAtmosphere(listed) || !irsg::isEnvironmentXml(file))
            continue;
        try {
            ofFile = irsg::environmentFromKarma(irsg::KarmaXml::read(file)).parameters.sun;
        } catch (const irsg::InputError&) {
            // The analysis says what is wrong with the file.
        }
    }
    return sunFrom(settings, ofFile);
}

std::vector<std::filesystem::path> resolvedAtmosphere(const Project& project,
                                                      const Settings& settings) {
    auto files = settings[key::environmentAtmospheres];
    for (auto& listed : files)
        listed = isNoAtmosphere(listed) ? listed : project.resolve(listed);
    return files;
}

irsg::Environment environmentOf(const Project& project, const Settings& settings) {
    irsg::Environment environment;
    environment.defaultAmbient_K = settings[key::environmentAmbientTemperature];

    // What the project names itself goes before an AtmosphereScatteringLUT of a file.
    const auto mtf = settings[key::environmentMtf];
    if (!mtf.empty()) {
        environment.add(std::make_shared<irsg::AtmosphereScatteringLut>(
            project.resolve(mtf.front()), 1e-3 * settings[key::environmentScatteringCoefficient]));
    }
    std::optional<int> bins_per_cm;
    if (settings[key::environmentBins] != "native")
        bins_per_cm = std::stoi(settings[key::environmentBins]);
    environment.sun = sunFrom(
        settings, addAtmosphere(environment, resolvedAtmosphere(project, settings), bins_per_cm));
    if (environment.atmospheres().size() == mtf.size()) {
        using enum irsg::Vacuum::Background;
        environment.add(
            std::make_shared<irsg::Vacuum>(environment.defaultBackground ? unknown : dark));
    }
    return environment;
}

std::string environmentKey(const Project& project, const Settings& settings) {
    std::string text = project.file.string();
    // All of the section, so that what is added to it is read again: but for the surroundings,
    // which SceneBuilder loads beside the environment.
    for (const SettingInfo& setting : settingTable()) {
        if (setting.section() != "environment" ||
            setting.key.starts_with(key::environmentSkybox.name) ||
            setting.key.starts_with(key::environmentTerrain.name))
            continue;
        const bool isOfSun = setting.key == key::environmentSunAzimuth ||
                             setting.key == key::environmentSunElevation;
        text += "|";
        if (isOfSun)
            text += settings.isSet(setting.key) ? "set" : "file";
        else
            text += settings.text(setting.key);
    }
    std::vector<std::filesystem::path> files = resolvedAtmosphere(project, settings);
    for (const std::filesystem::path& mtf : settings[key::environmentMtf])
        files.push_back(project.resolve(mtf));
    for (const std::filesystem::path& file : files)
        if (const auto stamp = irsg::stampOf(file))
            text += "|" + stamp->text();
    return text;
}

std::vector<Settings> eachBand(const Settings& settings) {
    std::vector<Settings> each;
    for (const std::filesystem::path& response : settings[key::sensorResponse]) {
        each.push_back(settings);
        each.back().set(key::sensorResponse, response.string());
    }
    const std::string& bands = settings.text(key::sensorBand);
    for (std::size_t begin = 0; each.empty() || (begin > 0 && begin <= bands.size());) {
        const std::size_t end = std::min(bands.find(',', begin), bands.size());
        each.push_back(settings);
        each.back().set(key::sensorBand, bands.substr(begin, end - begin));
        begin = end + 1;
    }
    return each.size() > 1 ? each : std::vector<Settings>{settings};
}

std::vector<irsg::Band> bandsOf(const Project& project, const Settings& settings) {
    std::vector<irsg::Band> bands;
    for (const Settings& one : eachBand(settings)) {
        bands.push_back(bandOf(project, one));
        if (std::find(bands.begin(), bands.end() - 1, bands.back()) != bands.end() - 1) {
            throw irsg::InputError({.file = project.displayName(),
                                    .position = key::sensorResponse,
                                    .value = settings.text(key::sensorResponse),
                                    .expected = "each response once"});
        }
    }
    return bands;
}

std::vector<std::string> bandLabels(const std::vector<irsg::Band>& bands) {
    std::vector<std::string> names;
    for (const irsg::Band& band : bands) {
        const irsg::SpectralRange range = band.range();
        names.push_back(band.isTopHat() ? irsg::numberText(range.min_um) + "-" +
                                              irsg::numberText(range.max_um) + "um"
                                        : std::filesystem::path(band.name()).stem().string());
    }
    return distinctLabels(std::move(names));
}

irsg::Sensor sensorOf(const Project& project, const Settings& settings) {
    // The settings' own ranges are within those of the sensor, which every picture checks.
    return {.width_px = settings[key::sensorWidth],
            .height_px = settings[key::sensorHeight],
            .horizontalFieldOfView_rad = irsg::radians(settings[key::sensorFov]),
            .band = bandOf(project, eachBand(settings).front())};
}

irsg::RenderSettings renderSettingsOf(const Settings& settings) {
    irsg::RenderSettings render;
    render.engine = valueOf(engineWords, settings.text(key::renderEngine));
    const int antialiasing = settings[key::renderAntialiasing];
    render.tileSide_samples = antialiasing > 2 ? 128 << (antialiasing - 3) : 0;
    render.tileStrategy = valueOf(zoomWords, settings.text(key::renderZoom));
    if (antialiasing <= 2)
        render.samplesPerAxis = 1 << antialiasing;
    render.pointSourceBelow_px = settings[key::renderPointSource];
    render.hotSpots = settings[key::renderHotSpots];
    render.countsPerPixel = valueOf(supersamplingWords, settings.text(key::renderSupersampling));
    render.sun = valueOf(reflectionWords, settings.text(key::renderSun));
    render.sunShadows = valueOf(shadowWords, settings.text(key::renderShadows));
    const std::optional<double> bounces = settings[key::renderBounces];
    if (bounces && *bounces != std::floor(*bounces))
        throw irsg::InputError({"settings", key::renderBounces.name,
                                settings.text(key::renderBounces),
                                "a whole number of reflections, or converged"});
    render.bounces = bounces ? static_cast<int>(*bounces) : irsg::convergedBounces;
    render.lightError = settings[key::renderLightError];
    render.widebandError = settings[key::renderWidebandError];
    render.ambientReflection =
        valueOf(reflectionWords, settings.text(key::renderAmbientReflection));
    if (settings.isSet(key::renderBounces) && render.bounces != 0 &&
        render.ambientReflection == irsg::ReflectionMode::approx)
        throw irsg::InputError(
            {"settings", key::renderBounces.name, settings.text(key::renderBounces),
             std::string("0, or ") + key::renderAmbientReflection.name +
                 " off or smart: approx is independent of geometry and has no inter-reflection"});
    render.mode = settings.text(key::sensorMode) == "ck" ? irsg::CalculationMode::wideband
                                                         : irsg::CalculationMode::spectral;
    render.fluxWeights = valueOf(fluxWeightWords, settings.text(key::renderFluxWeights));
    render.referenceTransmittance =
        valueOf(referenceTransmittanceWords, settings.text(key::renderReferenceTransmittance));
    const std::optional<double> radiance = settings[key::renderBackground];
    render.background = radiance ? irsg::BackgroundMode::constant
                        : settings.text(key::renderBackground) == "none"
                            ? irsg::BackgroundMode::none
                            : irsg::BackgroundMode::environment;
    render.background_W_m2_sr = radiance.value_or(0.0);
    render.backgroundRows = settings[key::renderBackgroundRows];
    render.backgroundColumns = settings[key::renderBackgroundColumns];
    render.sunDisc = settings[key::renderSunDisc];
    render.scattering = settings[key::renderScattering];
    render.skybox = {settings[key::environmentSkyboxSlope], settings[key::environmentSkyboxOffset]};
    render.terrain = {settings[key::environmentTerrainSlope],
                      settings[key::environmentTerrainOffset]};
    render.terrainHides = settings[key::renderTerrainHides];
    render.maximumLayers = settings[key::renderLayers];
    render.truthLayers = settings[key::imageTruthLayers];
    render.errors = settings.text(key::renderErrors) != "off";
    return render;
}

} // namespace smat
