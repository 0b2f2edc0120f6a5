#include "smatcore/support/Folders.h"

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"

namespace smat {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& what) {
    throw irsg::InputError({.file = folder.string(),
                            .position = "",
                            .value = "a place where no folder can be made",
                            .expected = "a folder for " + what});
}

} // namespace

void makeFolder(const fs::path& folder, const std::string& what) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure || !fs::is_directory(folder))
        refuse(folder, what);
}

void checkFolder(const fs::path& folder, const std::string& what) {
    std::error_code failure;
    fs::path there = fs::absolute(folder).lexically_normal();
    while (!fs::exists(fs::symlink_status(there, failure)) && there != there.parent_path())
        there = there.parent_path();
    if (!fs::is_directory(there, failure))
        refuse(folder, what);
    irsg::checkFolderWritable(there, folder);
}

} // namespace smat
