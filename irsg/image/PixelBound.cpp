#include "irsg/image/PixelBound.h"

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr std::uint64_t always = std::uint64_t{4} << 20, eachByte = 256;

} // namespace

void checkPixelCount(std::uint64_t values, std::uint64_t file_B, const std::string& file) {
    const std::uint64_t most = always + eachByte * file_B;
    if (values > most)
        throw InputError(
            {file, "header",
             std::to_string(values) + " values in " + std::to_string(file_B) + " bytes",
             "at most " + std::to_string(most) + " in a file of this size"});
}

} // namespace irsg
