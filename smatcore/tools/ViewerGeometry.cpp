#include "smatcore/tools/ViewerGeometry.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/support/ShellText.h"

namespace smat {

PathGeometryInput viewerGeometry(const Project& project, const Settings& settings,
                                 const irsg::Vec3& referencePoint_m) {
    const irsg::Vec3 target = targetPoseOf(settings).toWorld(referencePoint_m);
    const AnalysisCase view = planAnalysis(AnalysisKind::image, project, settings).cases.front();
    const irsg::Viewpoint camera = view.viewpoint(target);
    const irsg::Vec3 sight = camera.forward();
    double azimuth_deg = irsg::degrees(std::atan2(sight.x, sight.y));
    if (azimuth_deg < 0.0)
        azimuth_deg += 360.0;
    return {.sensorAltitude_m = camera.position_m.z,
            .losElevation_deg = irsg::degrees(std::asin(std::clamp(sight.z, -1.0, 1.0))),
            .losAzimuth_deg = azimuth_deg,
            .targetAltitude_m = target.z,
            .range_m = view.range_m};
}

irsg::Vec3 targetReferencePoint(const Project& project, SceneBuilder& scenes) {
    if (project.models.empty())
        return {};
    const ProjectModel& target = project.models.front();
    if (target.referencePoint_m)
        return *target.referencePoint_m;
    try {
        irsg::Entity entity;
        entity.model = scenes.model(project.resolve(target.file), target.options);
        entity.database = scenes.database(project.resolve(target.database));
        entity.fallbackMaterial = target.fallbackMaterial;
        const irsg::BoundingBox opaque = entity.model->boundsOf([&](const irsg::IrCodes& codes) {
            const irsg::Material* material = irsg::materialEntry(entity, codes.material);
            return material == nullptr || material->isOpaque();
        });
        return opaque.valid() ? opaque.centre() : entity.model->bounds().centre();
    } catch (const irsg::InputError&) {
        return {};
    }
}

std::vector<double> referenceDistancesOf_m(const Project& project, SceneBuilder& scenes) {
    std::set<double> distances_m;
    for (const ProjectModel& model : project.models) {
        try {
            for (const auto& [name, spectrum] :
                 scenes.database(project.resolve(model.database))->spectra)
                if (spectrum.referenceDistance_m > 0.0)
                    distances_m.insert(spectrum.referenceDistance_m);
        } catch (const irsg::InputError&) {
            continue; // an analysis says so
        }
    }
    return {distances_m.begin(), distances_m.end()};
}

std::string atmosphereArguments(const std::vector<std::filesystem::path>& air) {
    std::string arguments;
    for (const auto& one : air)
        arguments += " " + shellQuoted(one.string());
    return air.empty() ? " none" : arguments;
}

std::string radiativeCommand(const std::vector<std::filesystem::path>& air,
                             const std::vector<std::string>& words,
                             const PathGeometryInput& geometry, const irsg::SpectralRange& band,
                             const irsg::SunPosition& sun, std::optional<double> dayOfYear,
                             const std::string& outputFile,
                             const std::vector<double>& referenceDistances_m) {
    std::string command = "smat-batch radiative" + atmosphereArguments(air);
    const auto add = [&](const char* option, double value) {
        command += std::string(" ") + option + "=" + irsg::numberText(value);
    };
    for (const std::string& word : words)
        command += " --quantity " + word;
    command += " --band " + irsg::numberText(band.min_um) + "-" + irsg::numberText(band.max_um);
    if (geometry.sensorAltitude_m)
        add("--sensor-altitude", *geometry.sensorAltitude_m);
    if (geometry.targetAltitude_m)
        add("--altitude", *geometry.targetAltitude_m);
    if (geometry.range_m)
        add("--range", *geometry.range_m);
    if (geometry.losElevation_deg)
        add("--los-elevation", *geometry.losElevation_deg);
    add("--los-azimuth", geometry.losAzimuth_deg);
    for (const double distance_m : referenceDistances_m)
        add("--reference-distance", distance_m);
    // Angles of the sun were degrees before they were radians: twelve digits are what was typed.
    const auto typed = [](double angle_rad) {
        return std::stod(fmt::format("{:.12g}", irsg::degrees(angle_rad)));
    };
    add("--sun-azimuth", typed(sun.azimuth_rad));
    add("--sun-elevation", typed(sun.elevation_rad));
    if (dayOfYear)
        add("--day-of-year", *dayOfYear);
    return command + " --out " + shellQuoted(outputFile);
}

} // namespace smat
