#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

namespace {

/// What the project sets itself goes before the sun of an Environment file.
irsg::SunPosition sunFrom(const Settings& settings, const std::optional<irsg::SunPosition>& file) {
    irsg::SunPosition sun{.azimuth_rad = irsg::radians(settings.real("environment.sunAzimuth")),
                          .elevation_rad =
                              irsg::radians(settings.real("environment.sunElevation"))};
    if (file && !settings.isSet("environment.sunAzimuth")) {
        sun.azimuth_rad = file->azimuth_rad;
    }
    if (file && !settings.isSet("environment.sunElevation")) {
        sun.elevation_rad = file->elevation_rad;
    }
    return sun;
}

} // namespace

irsg::SunPosition sunOf(const Project& project, const Settings& settings) {
    std::optional<irsg::SunPosition> ofFile;
    for (const std::filesystem::path& listed : settings.paths("environment.atmospheres")) {
        const auto file = project.resolve(listed);
        if (ofFile || isNoAir(listed) || !irsg::isEnvironmentXml(file)) {
            continue;
        }
        try {
            ofFile = irsg::environmentFromKarma(irsg::KarmaXml::read(file)).parameters.sun;
        } catch (const irsg::InputError&) {
            // The analysis says what is wrong with the file.
        }
    }
    return sunFrom(settings, ofFile);
}

std::vector<std::filesystem::path> resolvedAir(const Project& project, const Settings& settings) {
    auto files = settings.paths("environment.atmospheres");
    for (auto& listed : files) {
        listed = isNoAir(listed) ? listed : project.resolve(listed);
    }
    return files;
}

irsg::Environment environmentOf(const Project& project, const Settings& settings) {
    irsg::Environment environment;
    environment.defaultAmbient_K = settings.real("environment.ambientTemperature");

    environment.sun = sunFrom(settings, addAir(environment, resolvedAir(project, settings)));
    if (environment.atmospheres().empty()) {
        environment.add(std::make_shared<irsg::Vacuum>());
    }
    return environment;
}

irsg::Sensor sensorOf(const Project& project, const Settings& settings) {
    const auto response = settings.paths("sensor.response");
    irsg::Sensor sensor{.width_px = settings.integer("sensor.width"),
                        .height_px = settings.integer("sensor.height"),
                        .horizontalFieldOfView_rad = irsg::radians(settings.real("sensor.fov")),
                        .band = response.empty()
                                    ? irsg::Band::fromText(settings.text("sensor.band"))
                                    : irsg::Band::fromCsv(project.resolve(response.front()))};
    sensor.check();
    return sensor;
}

irsg::RenderSettings renderSettingsOf(const Settings& settings) {
    const auto reflection = [&](std::string_view key) {
        const std::string& text = settings.text(key);
        return text == "off"      ? irsg::ReflectionMode::off
               : text == "approx" ? irsg::ReflectionMode::approx
                                  : irsg::ReflectionMode::smart;
    };
    irsg::RenderSettings render;
    const int antialiasing = settings.integer("render.antialiasing");
    render.zoomWindow = antialiasing > 2 ? 128 << (antialiasing - 3) : 0;
    render.zoomStrategy = settings.text("render.zoom") == "sills" ? irsg::ZoomStrategy::sills
                                                                  : irsg::ZoomStrategy::aligned;
    render.samplesPerAxis = antialiasing > 2 ? 1 : 1 << antialiasing;
    render.pointSourceBelow_px = settings.real("render.pointSource");
    render.hotParts = settings.boolean("render.hotParts");
    render.samplesInAll = settings.text("render.supersampling") == "inAll";
    render.sun = reflection("render.sun");
    render.fluxes = reflection("render.fluxes");
    render.mode = settings.text("sensor.mode") == "ck" ? irsg::CalculationMode::wideband
                                                       : irsg::CalculationMode::spectral;
    render.fluxWeights = settings.text("render.fluxWeights") == "report"
                             ? irsg::FluxWeights::report
                             : irsg::FluxWeights::viewFactor;
    const std::optional<double> radiance = settings.optionalReal("render.background");
    render.background = radiance ? irsg::BackgroundMode::constant
                        : settings.text("render.background") == "none"
                            ? irsg::BackgroundMode::none
                            : irsg::BackgroundMode::environment;
    render.background_W_m2_sr = radiance.value_or(0.0);
    render.backgroundRows = settings.integer("render.backgroundRows");
    render.backgroundColumns = settings.integer("render.backgroundColumns");
    render.sunDisc = settings.boolean("render.sunDisc");
    render.skybox = {settings.real("environment.skyboxSlope"),
                     settings.real("environment.skyboxOffset")};
    render.terrain = {settings.real("environment.terrainSlope"),
                      settings.real("environment.terrainOffset")};
    render.terrainHides = settings.boolean("render.terrainHides");
    render.maximumLayers = settings.integer("render.layers");
    render.truthLayers = settings.boolean("image.truthLayers");
    return render;
}

} // namespace smat
