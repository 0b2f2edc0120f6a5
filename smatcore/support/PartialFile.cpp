#include "smatcore/support/PartialFile.h"

#include <fstream>
#include <string>
#include <system_error>

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
    std::error_code failure;
    if (!fs::is_regular_file(file, failure))
        return false;
    // Not by readFile(): what a run takes for an input it refuses to write over.
    std::ifstream in(file, std::ios::binary);
    std::string text(beginning, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
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
