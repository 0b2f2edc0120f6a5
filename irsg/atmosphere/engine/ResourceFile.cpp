#include "irsg/atmosphere/engine/ResourceFile.h"

#include <cstdlib>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

std::filesystem::path atmosphereResource(const std::string& name) {
    namespace fs = std::filesystem;
    std::vector<fs::path> folders;
    if (const char* own = std::getenv("SMAT_RESOURCES"); own && *own)
        folders.emplace_back(fs::path(own) / "atmosphere");
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty())
        folders.emplace_back(program.parent_path().parent_path() / "share" / "smat" / "atmosphere");
    folders.emplace_back(fs::path(SMAT_SOURCE_RESOURCES) / "atmosphere");

    std::string searched;
    for (const fs::path& folder : folders) {
        if (fs::exists(folder / name, ignored))
            return folder / name;
        searched += (searched.empty() ? "" : ", ") + folder.string();
    }
    throw InputError(
        Diagnostic{name, "", "no such file", "a table of the atmosphere in " + searched});
}

} // namespace irsg
