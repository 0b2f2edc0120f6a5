#include "smatcore/project/NamedPaths.h"

#include <system_error>

#include "irsg/core/AppendUnique.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/ShippedFiles.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

irsg::WrittenPath namedPath(const std::filesystem::path& document,
                            const std::filesystem::path& path) {
    if (path.empty())
        return {};
    const bool isFree = path.is_absolute() || document.empty();
    const std::filesystem::path folder = isFree ? std::filesystem::path() : document.parent_path();
    const std::filesystem::path plain = isFree ? path : (folder / path).lexically_normal();
    std::error_code failure;
    if (std::filesystem::exists(plain, failure))
        return {plain, ""};
    irsg::WrittenPath found = irsg::findWritten(folder, path.string());
    if (found.file.empty()) {
        if (const std::filesystem::path shipped = shippedFile(path); !shipped.empty())
            return {shipped, path.string() + ": not found there; the file of that name that comes "
                                             "with the program is read"};
        return {plain, ""};
    }
    if (!isFree)
        found.file = found.file.lexically_normal();
    return found;
}

std::vector<std::string> remarksOnNames(const Project& project, const Settings& settings) {
    std::vector<std::string> remarks;
    const auto look = [&](const std::filesystem::path& path) {
        const std::string remark = namedPath(project.file, path).remark;
        if (!remark.empty())
            irsg::appendUnique(remarks, remark);
    };
    for (const ProjectModel& model : project.models) {
        look(model.file);
        look(model.database);
    }
    for (const SettingInfo& setting : settingTable())
        if (setting.kind == SettingKind::path || setting.kind == SettingKind::pathList)
            for (const std::filesystem::path& path : settings[PathsKey{setting.key.c_str()}])
                if (!isNoAtmosphere(path))
                    look(path);
    return remarks;
}

} // namespace smat
