#include "smatcore/support/TextFile.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReplacement.h"

namespace smat {

namespace {

constexpr std::uintmax_t largestFile = std::uintmax_t{256} << 20;

[[noreturn]] void refuse(const std::filesystem::path& file, const char* value,
                         const char* expected) {
    throw irsg::InputError(
        {.file = file.string(), .position = "", .value = value, .expected = expected});
}

} // namespace

std::string readTextFile(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::exists(file, failure)) {
        refuse(file, "no such file", "a file that exists");
    }
    if (!std::filesystem::is_regular_file(file, failure)) {
        refuse(file, "something that is no file", "a file");
    }
    if (std::filesystem::file_size(file, failure) > largestFile) {
        refuse(file, "more than 256 MiB", "a text file of a sensible size");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream && text.empty()) {
        refuse(file, "a file that cannot be opened", "a file that may be read");
    }
    return text;
}

void writeTextFile(const std::filesystem::path& file, std::string_view text) {
    irsg::writeFileDurably(file, text);
}

} // namespace smat
