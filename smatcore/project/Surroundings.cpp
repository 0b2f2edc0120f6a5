#include <algorithm>
#include <array>
#include <system_error>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/Terrain.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

/// A file's name and stamp as a text that changes with the file.
std::string stampText(const std::filesystem::path& file) {
    return file.string() + "|" + irsg::stampOf(file).value_or(irsg::FileStamp()).text() + "|";
}

/// Runs `load` and puts the setting's key before the position of what it refuses.
template <typename Load>
auto naming(const std::string& key, const Load& load) {
    return irsg::editing(load, [&](irsg::Diagnostic& one) {
        one.position = key + (one.position.empty() ? "" : ", " + one.position);
    });
}

} // namespace

std::shared_ptr<const irsg::Skybox> SceneBuilder::skybox(const Project& project,
                                                         const Settings& settings) {
    const std::vector<std::filesystem::path> listed = settings[key::environmentSkybox];
    if (listed.empty())
        return nullptr;
    return naming(key::environmentSkybox, [&] {
        std::array<std::filesystem::path, 6> files;
        if (listed.size() == 1) {
            files = irsg::Skybox::filesIn(project.resolve(listed.front()));
        } else if (listed.size() == files.size()) {
            std::ranges::transform(listed, files.begin(), [&](const std::filesystem::path& file) {
                return project.resolve(file);
            });
        } else {
            throw irsg::InputError({.file = project.displayName(),
                                    .position = "",
                                    .value = std::to_string(listed.size()) + " files",
                                    .expected = "a folder, or six files: north, south, east, west, "
                                                "up, down"});
        }
        std::string stamp;
        for (const std::filesystem::path& file : files)
            stamp += stampText(file);
        if (!skybox_.second || skybox_.first != stamp) {
            logInfo("loading skybox " + files.front().parent_path().string());
            skybox_ = {stamp, irsg::Skybox::load(files)};
        }
        return skybox_.second;
    });
}

std::shared_ptr<const irsg::Terrain> SceneBuilder::terrain(const Project& project,
                                                           const Settings& settings) {
    const std::vector<std::filesystem::path> listed = settings[key::environmentTerrain];
    if (listed.empty())
        return nullptr;
    const irsg::Vec3 position_m{settings[key::environmentTerrainEast],
                                settings[key::environmentTerrainNorth],
                                settings[key::environmentTerrainAltitude]};
    return naming(key::environmentTerrain, [&] {
        const std::filesystem::path file = project.resolve(listed.front());
        const std::string stamp = stampText(file) + irsg::numberText(position_m.x) + "|" +
                                  irsg::numberText(position_m.y) + "|" +
                                  irsg::numberText(position_m.z);
        if (!terrain_.second || terrain_.first != stamp) {
            logInfo("loading terrain " + file.string());
            terrain_ = {stamp, irsg::Terrain::load(file, position_m)};
        }
        return terrain_.second;
    });
}

} // namespace smat
