#include "irsg/render/opengl/DriverCache.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// Of a cache that is new: its index alone takes 1.3 MB.
constexpr std::uintmax_t room_B = std::uintmax_t{64} << 20;

/// Where Mesa keeps its cache, or a folder above it that is there; empty where that is not known.
fs::path cachePlace() {
    fs::path place;
    for (const char* name :
         {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME", "HOME"}) {
        const char* const folder = std::getenv(name);
        if (folder != nullptr && *folder != '\0') {
            place = folder;
            break;
        }
    }
    // Of the home what is below it may be another disk.
    std::error_code failure;
    for (const char* below : {".cache", "mesa_shader_cache"})
        if (!place.empty() && fs::is_directory(place / below, failure))
            place /= below;
    while (!place.empty() && !fs::is_directory(place, failure) && place != place.parent_path())
        place = place.parent_path();
    return place;
}

} // namespace

void keepOffFullShaderCache() {
    const fs::path place = cachePlace();
    if (place.empty())
        return;
    std::error_code failure;
    const fs::space_info space = fs::space(place, failure);
    if (failure || space.available >= room_B)
        return;
    // The second name is that of Mesa before 22.
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"})
        setenv(name, "true", 0);
}

} // namespace irsg
