#include "smatcore/project/SceneBuilder.h"

#include <algorithm>
#include <system_error>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/NamedPaths.h"
#include "smatcore/project/SceneScalings.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

using irsg::collect;

void addRemarks(std::vector<std::string>& remarks, const irsg::Model* model,
                const std::filesystem::path& file) {
    if (model == nullptr)
        return;
    for (const std::string& remark : model->remarks()) {
        const std::string sentence = file.filename().string() + ": " + remark;
        if (std::find(remarks.begin(), remarks.end(), sentence) == remarks.end())
            remarks.push_back(sentence);
    }
}

} // namespace

SceneBuilder::SceneBuilder(ModelLoader loader) : loader_(std::move(loader)) {
    if (!loader_) {
        loader_ = [](const std::filesystem::path& file, const irsg::ModelOptions& options) {
            return std::shared_ptr<const irsg::Model>(irsg::Model::load(file, options));
        };
    }
}

SceneDescription SceneBuilder::build(const Project& project, const Settings& settings,
                                     const irsg::Environment* environment) {
    SceneDescription scene;
    std::vector<irsg::Diagnostic> diagnostics;
    scene.remarks = remarksOnNames(project, settings);
    collect(diagnostics, [&] {
        scene.environment = environment ? *environment : environmentOf(project, settings);
    });
    collect(diagnostics, [&] {
        scene.sensor = sensorOf(project, settings);
        scene.setBands(bandsOf(project, settings));
    });
    scene.settings = renderSettingsOf(settings);
    collect(diagnostics, [&] { scene.skybox = skybox(project, settings); });
    collect(diagnostics, [&] {
        scene.terrain = terrain(project, settings);
        if (scene.terrain)
            for (const std::string& remark : scene.terrain->remarks())
                scene.remarks.push_back(scene.terrain->name() + ": " + remark);
    });

    if (project.models.empty()) {
        diagnostics.push_back({.file = project.displayName(),
                               .position = "models",
                               .value = "no model",
                               .expected = "at least one model"});
    }
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const ProjectModel& given = project.models[i];
        irsg::Entity entity;
        entity.name = given.shownName();
        collect(diagnostics, [&] {
            entity.model = model(project.resolve(given.file), given.options);
            addRemarks(scene.remarks, entity.model.get(), given.file);
        });
        if (given.database.empty()) {
            diagnostics.push_back({.file = project.displayName(),
                                   .position = "models." + std::to_string(i) + ".database",
                                   .value = "nothing",
                                   .expected = "a signature database (.sigdb): File > First "
                                               "signature from names, or 'smat-batch model codes "
                                               "MODEL --suggest --database FILE', makes one"});
        } else {
            const auto file = project.resolve(given.database);
            collect(diagnostics, [&] { entity.database = database(file); });
            if (overrides_.contains(file))
                scene.unsavedDatabases.insert(i);
        }
        entity.pose = poseOf(project, settings, i);
        scene.own.push_back(i == 0 ? StateOverride() : given.own);
        entity.state = scene.own.back().where(targetStateOf(settings));
        entity.referencePoint_m = given.referencePoint_m;
        entity.fallbackTemperature = given.fallbackTemperature;
        entity.fallbackMaterial = given.fallbackMaterial;
        scene.entities.push_back(std::move(entity));
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    if (settings[key::scalingUse])
        applyScalings(project, static_cast<std::uint64_t>(settings[key::scalingSeed]), scene);
    return scene;
}

std::shared_ptr<const irsg::Model> SceneBuilder::model(const std::filesystem::path& file,
                                                       const irsg::ModelOptions& options) {
    stampOf(file, "a model");
    const irsg::ModelStamp stamp = irsg::modelStampOf(file);
    const ModelKey key{file, options};
    const auto kept = models_.find(key);
    std::shared_ptr<const irsg::Model> loaded;
    if (kept != models_.end() && kept->second.stamp == stamp) {
        loaded = kept->second.value;
    } else {
        logInfo("loading model " + file.string());
        loaded = loader_(file, options);
        models_[key] = {stamp, loaded};
    }
    return loaded;
}

std::shared_ptr<const irsg::SignatureDatabase>
SceneBuilder::database(const std::filesystem::path& file) {
    if (const auto edited = overrides_.find(file); edited != overrides_.end())
        return edited->second;
    const irsg::FileStamp stamp = stampOf(file, "a signature database");
    const auto kept = databases_.find(file.string());
    if (kept != databases_.end() && kept->second.stamp == stamp)
        return kept->second.value;
    logInfo("loading signature database " + file.string());
    auto loaded =
        std::make_shared<const irsg::SignatureDatabase>(irsg::loadSignatureFile(file).database);
    databases_[file.string()] = {stamp, loaded};
    return loaded;
}

void SceneBuilder::setDatabaseOverrides(DatabaseOverrides overrides) {
    overrides_ = std::move(overrides);
}

irsg::FileStamp SceneBuilder::stampOf(const std::filesystem::path& file, const char* what) {
    const auto stamp = irsg::stampOf(file);
    std::error_code unknown;
    if (!stamp)
        throw irsg::InputError(
            {.file = file.string(),
             .position = "",
             .value = std::filesystem::is_directory(file, unknown) ? "a folder" : "no such file",
             .expected = what + std::string(" that exists")});
    return *stamp;
}

irsg::EntityState targetStateOf(const Settings& settings) {
    irsg::EntityState state;
    state.time_s = settings[key::stateTime];
    state.power = settings[key::statePower];
    state.mach = settings[key::stateMach];
    return state;
}

irsg::Pose targetPoseOf(const Settings& settings) {
    return {.position_m = {0.0, 0.0, settings[key::targetAltitude]},
            .attitude = {irsg::radians(settings[key::targetYaw]),
                         irsg::radians(settings[key::targetPitch]),
                         irsg::radians(settings[key::targetRoll])}};
}

irsg::Pose poseOf(const Project& project, const Settings& settings, std::size_t model) {
    return model == 0 ? targetPoseOf(settings) : project.models.at(model).pose;
}

irsg::EntityState stateOf(const Project& project, const Settings& settings, std::size_t model) {
    const irsg::EntityState ofTarget = targetStateOf(settings);
    return model == 0 ? ofTarget : project.models.at(model).own.where(ofTarget);
}

} // namespace smat
