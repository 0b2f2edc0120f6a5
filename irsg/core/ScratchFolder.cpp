#include "irsg/core/ScratchFolder.h"

#include <cstdlib>
#include <system_error>

#include <unistd.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& what) {
    throw InputError({folder.string(), "", "a place that takes no temporary files",
                      "a folder that may be written, for " + what +
                          " (the environment variable TMPDIR names it)"});
}

} // namespace

fs::path scratchPlace(const std::string& what) {
    const char* const named = std::getenv("TMPDIR");
    const fs::path folder = named != nullptr && *named != '\0' ? named : "/tmp";
    std::error_code failure;
    if (!fs::is_directory(folder, failure) || access(folder.c_str(), W_OK | X_OK) != 0)
        refuse(folder, what);
    return folder;
}

ScratchFolder::ScratchFolder(const std::string& what) {
    const fs::path place = scratchPlace(what);
    std::string pattern = (place / "smat-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
        refuse(place, what);
    folder_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

} // namespace irsg
