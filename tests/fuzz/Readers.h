#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace smat::test {

/// A reader of ours, and files of the samples to begin with.
struct FuzzedReader {
    const char* name;
    std::string extension; ///< what a file for it ends in
    /// Reads a file; what it throws besides InputError is a finding, and so is a crash.
    std::function<void(const std::filesystem::path& file)> read;
    std::vector<std::string> seeds;     ///< files, from the top of the tree
    std::vector<std::string> seedTexts; ///< what no sample has
    /// Of what libFuzzer makes up: what is longer says no more, and takes its time.
    std::size_t longest_B = 4096;
};

const std::vector<FuzzedReader>& fuzzedReaders();
/// Those of them that read binary files and messages, and what other files name.
std::vector<FuzzedReader> packedReaders();
/// Those that read what programs keep for themselves.
std::vector<FuzzedReader> keptReaders();
/// Those that read what analyses gave.
std::vector<FuzzedReader> resultReaders();

/// Gives some bytes to a reader, as a file in memory; whether it read them, or refused them.
bool readBytes(const FuzzedReader& reader, std::string_view bytes);

/// The seeds themselves.
std::vector<std::string> seedsOf(const FuzzedReader& reader);

} // namespace smat::test
