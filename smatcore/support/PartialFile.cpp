#include "smatcore/support/PartialFile.h"

#include <string>
#include <system_error>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"

namespace smat {

namespace {

namespace fs = std::filesystem;

/// In bytes: provenance stands before the numbers.
constexpr std::size_t beginning = std::size_t{1} << 18;
/// Between the name of an entry of provenance and its value, in all forms.
constexpr std::size_t farthest = 40;

} // namespace

fs::path partialFileBeside(const fs::path& file) {
    return file.parent_path() / (file.stem().string() + ".partial" + file.extension().string());
}

bool isPartialResult(const fs::path& file) {
    std::string text;
    try {
        text = irsg::readFileBeginning(file, beginning);
    } catch (const irsg::InputError&) {
        return false;
    }
    for (std::size_t at = text.find("state"); at != std::string::npos;
         at = text.find("state", at + 1))
        if (text.substr(at, farthest).find("partial") != std::string::npos)
            return true;
    return false;
}

fs::path placeOfPartial(const fs::path& file) {
    std::error_code failure;
    // A device or a pipe keeps nothing.
    return fs::is_regular_file(file, failure) && !isPartialResult(file) ? partialFileBeside(file)
                                                                        : file;
}

void removePartialBeside(const fs::path& file) {
    const fs::path beside = partialFileBeside(file);
    std::error_code ignored;
    if (isPartialResult(beside))
        fs::remove(beside, ignored);
}

} // namespace smat
