#include "smatcore/support/TextFile.h"

#include "irsg/radiometry/FileReading.h"
#include "irsg/radiometry/FileReplacement.h"

namespace smat {

namespace {

constexpr std::uint64_t largestText_B = std::uint64_t{256} << 20;

} // namespace

std::string readTextFile(const std::filesystem::path& file) {
    return irsg::readFile(file, largestText_B);
}

void writeTextFile(const std::filesystem::path& file, std::string_view text) {
    irsg::writeFileDurably(file, text);
}

} // namespace smat
