#include "smatcore/project/SceneScalings.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using irsg::ScalingKind;

const char* word(ScalingKind kind) {
    return kind == ScalingKind::temperature ? "temperature" : "emissivity";
}

/// Why a scale has no effect; empty where it has one.
std::string idleBecause(const irsg::Entity& entity, ScalingKind kind, int index) {
    const bool isTemperature = kind == ScalingKind::temperature;
    const auto entry = entity.database->temperatures.find(index);
    const bool hasEntry = isTemperature ? entry != entity.database->temperatures.end()
                                        : entity.database->materials.contains(index);
    if (!hasEntry)
        return "has no entry in the signature database";
    if (isTemperature && entry->second.mode == irsg::EmissionMode::userSpectrum)
        return "is a user-defined spectrum, which no temperature scales";
    const auto carries = [&](const auto& use) {
        return (isTemperature ? use.first.temperature : use.first.material) == index;
    };
    if (entity.model &&
        std::none_of(entity.model->codes().begin(), entity.model->codes().end(), carries)) {
        return "is on no face of the model";
    }
    return "";
}

std::string nameOf(const irsg::Entity& entity, ScalingKind kind, int index) {
    const std::string& entry = kind == ScalingKind::temperature
                                   ? entity.database->temperatures.at(index).name
                                   : entity.database->materials.at(index).name;
    const std::string plain = fmt::format("{} {}", word(kind), index);
    return entry.empty() ? plain : fmt::format("{} ({})", plain, entry);
}

} // namespace

double SceneScaling::at(std::uint64_t seed, std::uint64_t draw) const {
    return distribution.at(irsg::unitOf(seed,
                                        {static_cast<std::uint32_t>(input.kind),
                                         static_cast<std::uint32_t>(input.entity), input.index},
                                        draw));
}

std::vector<SceneScaling> sceneScalings(const Project& project, const SceneDescription& scene,
                                        std::vector<std::string>& remarks) {
    std::vector<SceneScaling> found;
    std::vector<irsg::Diagnostic> diagnostics;
    bool anyFile = false;
    for (std::size_t e = 0; e < project.models.size() && e < scene.entities.size(); ++e) {
        const irsg::Entity& entity = scene.entities[e];
        const std::filesystem::path model = project.resolve(project.models[e].file);
        if (!irsg::hasScalingFiles(model))
            continue;
        anyFile = true;
        irsg::Scalings scalings; // none where they are refused
        irsg::collect(diagnostics, [&] { scalings = irsg::loadScalings(model); });
        for (const ScalingKind kind : {ScalingKind::temperature, ScalingKind::emissivity}) {
            for (const auto& [index, entry] : scalings.of(kind)) {
                const irsg::Distribution& distribution = entry.distribution;
                if (distribution.isFixed() && distribution.minimum() == 1.0)
                    continue;
                if (const std::string why = idleBecause(entity, kind, index); !why.empty()) {
                    remarks.push_back(
                        fmt::format("{}: the scale of {} {} has no effect, it {}",
                                    irsg::scalingFile(model, kind).filename().string(), word(kind),
                                    index, why));
                    continue;
                }
                const std::string whose = scene.entities.size() > 1 ? entity.name + " " : "";
                found.push_back({{static_cast<int>(e), kind, index, distribution.minimum(),
                                  distribution.maximum()},
                                 distribution,
                                 whose + nameOf(entity, kind, index)});
            }
        }
    }
    if (!anyFile && !project.models.empty()) {
        const std::filesystem::path model = project.resolve(project.models.front().file);
        diagnostics.push_back(
            {.file = irsg::scalingFile(model, ScalingKind::temperature).string(),
             .position = "",
             .value = "no such file",
             .expected =
                 "a scaling file beside the model; saving its signature database makes one"});
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return found;
}

std::map<int, double>& scalesOf(irsg::Entity& entity, ScalingKind kind) {
    return kind == ScalingKind::temperature ? entity.temperatureScale : entity.emissivityScale;
}

void applyScalings(const Project& project, std::uint64_t seed, SceneDescription& scene) {
    for (const SceneScaling& scaling : sceneScalings(project, scene, scene.remarks)) {
        irsg::Entity& entity = scene.entities[static_cast<std::size_t>(scaling.input.entity)];
        const double value = scaling.at(seed, 0);
        scalesOf(entity, scaling.input.kind)[scaling.input.index] = value;
        scene.sampledScales.push_back(
            fmt::format("{}: {}{}", scaling.name, irsg::numberText(value),
                        scaling.isFixed() ? "" : ", " + describe(scaling.distribution)));
    }
}

std::string describe(const irsg::Distribution& distribution) {
    if (distribution.isFixed())
        return irsg::numberText(distribution.minimum());
    const auto& law = irsg::info(distribution.kind());
    std::string text =
        fmt::format("{}, {} to {}", law.name, irsg::numberText(distribution.minimum()),
                    irsg::numberText(distribution.maximum()));
    if (!distribution.hasDefaultParameters())
        for (std::size_t i = 0; i < distribution.parameters().size(); ++i)
            text += fmt::format(", {} {}", law.parameters[i],
                                irsg::numberText(distribution.parameters()[i]));
    return text;
}

void tellSampledScales(const SceneDescription& scene, const Settings& settings,
                       Provenance& provenance) {
    if (scene.sampledScales.empty())
        return;
    if (settings.isDefault(key::scalingSeed))
        provenance.add(key::scalingSeed.name, settings.text(key::scalingSeed));
    for (const std::string& drawn : scene.sampledScales)
        provenance.add("drawn scale", drawn);
}

} // namespace smat
