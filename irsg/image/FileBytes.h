#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace irsg {

/// The whole of a file. Throws InputError where it is missing, a folder, or cannot be read.
std::string readFileBytes(const std::filesystem::path& file);

/// Writes `bytes` beside `file` and renames the result onto it, so that a full disk or a
/// cancelled program never leaves half a file or destroys the one that was there. What is not a
/// regular file (/dev/stdout, a pipe) is written directly. Throws InputError with the system's
/// reason.
void writeFileBytes(const std::filesystem::path& file, std::string_view bytes);

} // namespace irsg
