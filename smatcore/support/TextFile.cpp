#include "smatcore/support/TextFile.h"

#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

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
