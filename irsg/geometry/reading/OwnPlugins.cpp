#include "irsg/geometry/reading/OwnPlugins.h"

#include <filesystem>
#include <mutex>

#include <dlfcn.h>
#include <osgDB/Registry>

namespace irsg {

namespace {

void findOwnPlugins() {
    namespace fs = std::filesystem;
    static const char here = 0;
    Dl_info info{};
    std::error_code failure;
    if (dladdr(&here, &info) == 0 || !info.dli_fname)
        return;
    osgDB::Registry& registry = *osgDB::Registry::instance();
    const std::string plugin = registry.createLibraryNameForExtension("flt");
    const fs::path folder = fs::canonical(info.dli_fname, failure).parent_path();
    for (const fs::path& place : {folder, folder.parent_path() / "lib"}) {
        if (fs::exists(place / plugin, failure)) {
            registry.getLibraryFilePathList().push_front(place.string());
            return;
        }
    }
}

} // namespace

void preferOwnPlugins() {
    static std::once_flag once;
    std::call_once(once, findOwnPlugins);
}

} // namespace irsg
