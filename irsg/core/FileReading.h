#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// More is no input of ours: a wrong file, or one that has no end.
constexpr std::uint64_t largestFile_B = std::uint64_t{1} << 30;

/// The whole of a regular file. Throws InputError where it is missing, no regular file (a folder, a
/// device, a pipe), larger than `most_B`, or cannot be read to its end.
std::string readFile(const std::filesystem::path& file, std::uint64_t most_B = largestFile_B);

/// The same in pieces of at most 1 MiB, each given to `take` and forgotten: for what follows from
/// the bytes of large files.
void readFileInPieces(const std::filesystem::path& file,
                      const std::function<void(std::string_view)>& take,
                      std::uint64_t most_B = largestFile_B);

/// Its first bytes, at most `size`. Throws as readFile() does, whatever the size of the file.
std::string readFileBeginning(const std::filesystem::path& file, std::size_t size);

/// From here on what is read through this file is remembered, and FileReplacement refuses to write
/// over it: for programs whose inputs and outputs are given on one line.
void protectInputs();
/// Remembers a file that is read in another way.
void noteInput(const std::filesystem::path& file);
/// The files that were read since, in any order, each once.
std::vector<std::filesystem::path> inputsRead();
/// Throws InputError where an output is a file that was read, under whatever name.
void refuseInputAsOutput(const std::filesystem::path& output);
/// A file that is read in order to be changed.
void allowChange(const std::filesystem::path& file);

} // namespace irsg
