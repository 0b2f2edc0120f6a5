#include "irsg/atmosphere/engine/ResourceFile.h"

#include <cstdlib>
#include <vector>

#include <dlfcn.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// Where this library stands; empty where the system does not say.
fs::path libraryFolder() {
    static const char here = 0;
    Dl_info info{};
    std::error_code ignored;
    if (dladdr(&here, &info) == 0 || !info.dli_fname)
        return {};
    return fs::canonical(info.dli_fname, ignored).parent_path();
}

} // namespace

std::filesystem::path atmosphereResource(const std::string& name) {
    std::vector<fs::path> folders;
    if (const char* own = std::getenv("SMAT_RESOURCES"); own && *own)
        folders.emplace_back(fs::path(own) / "atmosphere");
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty())
        folders.emplace_back(program.parent_path().parent_path() / "share" / "smat" / "atmosphere");
    // Of programs that stand elsewhere, such as an interpreter.
    if (const fs::path library = libraryFolder(); !library.empty())
        for (const char* place : {"..", "../.."})
            folders.emplace_back(
                (library / place / "share" / "smat" / "atmosphere").lexically_normal());
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
