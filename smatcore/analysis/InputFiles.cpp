#include "smatcore/analysis/InputFiles.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileStamp.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/Sha256.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {
namespace {

namespace fs = std::filesystem;

constexpr const char *modelRole = "model", *codesRole = "codes", *databaseRole = "database",
                     *scalingRole = "scaling", *partRole = "air";
constexpr std::size_t shownDigits = 16;

bool isFile(const fs::path& file) {
    std::error_code failure;
    return fs::is_regular_file(file, failure);
}

/// Of an Environment file what it is composed of, where that is found.
std::vector<fs::path> composedOf(const fs::path& environment) {
    std::vector<fs::path> files;
    if (!irsg::isEnvironmentXml(environment))
        return files;
    try {
        const auto read = irsg::environmentFromKarma(irsg::KarmaXml::read(environment));
        for (const irsg::KarmaComposite& composite : read.parameters.composition)
            files.push_back(irsg::resolveKarmaPath(composite.parameters, environment));
    } catch (const irsg::InputError&) {
        // What cannot be read is told by whoever has to read it.
    }
    return files;
}

} // namespace

std::vector<InputFile> inputFilesOf(const Project& project, const Settings& settings,
                                    AnalysisKind kind) {
    std::vector<InputFile> inputs;
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const fs::path model = project.resolve(project.models[i].file);
        inputs.push_back({modelRole, model, i});
        if (const fs::path codes = irsg::codesFileOf(model); isFile(codes))
            inputs.push_back({codesRole, codes, i});
        inputs.push_back({databaseRole, project.resolve(project.models[i].database), i});
        if (!settings[key::scalingUse])
            continue;
        for (const auto of : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity})
            if (const fs::path scaling = irsg::scalingFile(model, of); isFile(scaling))
                inputs.push_back({scalingRole, scaling, i});
    }
    for (const SettingInfo& setting : settingTable()) {
        if ((setting.kind != SettingKind::path && setting.kind != SettingKind::pathList) ||
            !concerns(setting, kind->name))
            continue;
        const auto listed = settings[PathsKey{setting.key.c_str()}];
        for (std::size_t i = 0; i < listed.size(); ++i) {
            if (isNoAtmosphere(listed[i]))
                continue;
            const fs::path file = project.resolve(listed[i]);
            inputs.push_back({setting.key, file, i});
            for (const fs::path& part : composedOf(file))
                inputs.push_back({partRole, part, i});
        }
    }
    return inputs;
}

bool isReplaceable(const InputFile& input) {
    return input.role == modelRole || input.role == databaseRole ||
           findSetting(input.role) != nullptr;
}

void replaceInput(Project& project, Settings& settings, const InputFile& input,
                  const std::filesystem::path& by) {
    if (input.role == modelRole) {
        project.models.at(input.number).file = by;
    } else if (input.role == databaseRole) {
        project.models.at(input.number).database = by;
    } else if (findSetting(input.role) != nullptr) {
        auto listed = settings[PathsKey{input.role.c_str()}];
        std::string text;
        for (std::size_t i = 0; i < listed.size(); ++i)
            text += (i == 0 ? "" : ";") + (i == input.number ? by : listed[i]).string();
        settings.set(input.role, text);
    } else {
        throw irsg::LogicError("an input of the role " + input.role + " is named by another file");
    }
}

std::string fileHash(const fs::path& file) {
    static std::mutex mutex;
    static std::map<fs::path, std::pair<std::string, std::string>> known; // stamp and hash
    const auto stamp = irsg::stampOf(file);
    if (stamp) {
        const std::scoped_lock lock(mutex);
        const auto found = known.find(file);
        if (found != known.end() && found->second.first == stamp->text())
            return found->second.second;
    }
    irsg::Sha256 ofBytes;
    irsg::readFileInPieces(file, [&](std::string_view bytes) { ofBytes.add(bytes); });
    const std::string hash = ofBytes.text();
    if (stamp) {
        const std::scoped_lock lock(mutex);
        known[file] = {stamp->text(), hash};
    }
    return hash;
}

std::string contentHash(const std::filesystem::path& file) {
    const auto shown = [](const fs::path& one) {
        try {
            return fileHash(one).substr(0, shownDigits);
        } catch (const irsg::InputError&) {
            return std::string();
        }
    };
    std::error_code failure;
    if (!fs::is_directory(file, failure))
        return shown(file);
    std::set<std::string> parts;
    for (const auto& entry : fs::directory_iterator(file, failure))
        if (isFile(entry.path()))
            parts.insert(entry.path().filename().string() + " " + shown(entry.path()));
    std::string all;
    for (const std::string& part : parts)
        all += part + "\n";
    return irsg::sha256(all).substr(0, shownDigits);
}

} // namespace smat
