#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace smat::test {

/// A file or folder of the shared material, which lies beside the checkout or where SMAT_SHARED
/// says; an empty path where it is not there.
inline std::filesystem::path sharedMaterial(const std::string& name) {
    const char* const stated = std::getenv("SMAT_SHARED");
    const std::filesystem::path folder =
        stated && *stated ? std::filesystem::path(stated)
                          : std::filesystem::path(SMAT_SOURCE_DIR).parent_path() / "shared";
    std::error_code ignored;
    return std::filesystem::exists(folder / name, ignored) ? folder / name
                                                           : std::filesystem::path();
}

} // namespace smat::test
