#include "smatcore/support/Folders.h"

#include "irsg/core/Errors.h"

namespace smat {

void makeFolder(const std::filesystem::path& folder, const std::string& what) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw irsg::InputError({.file = folder.string(),
                                .position = "",
                                .value = "a place where no folder can be made",
                                .expected = "a folder for " + what});
    }
}

} // namespace smat
