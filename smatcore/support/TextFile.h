#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace smat {

/// The whole of a text file. Throws InputError where it is missing, no file, larger than 256 MiB or
/// cannot be read.
std::string readTextFile(const std::filesystem::path& file);

/// Writes a file whole or not at all (irsg::writeFileDurably): into a neighbour first, which then
/// takes its place. Throws InputError where the folder is missing or nothing can be written there.
void writeTextFile(const std::filesystem::path& file, std::string_view text);

} // namespace smat
