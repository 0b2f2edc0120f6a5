#pragma once

#include <cstdint>
#include <string>

namespace irsg {

/// Throws InputError where a picture has far more values than a file of its size can be meant to
/// hold: more than 4 Mi and 256 for each byte. Called before memory is taken, so that some bytes
/// cannot take gigabytes.
void checkPixelCount(std::uint64_t values, std::uint64_t file_B, const std::string& file);

} // namespace irsg
