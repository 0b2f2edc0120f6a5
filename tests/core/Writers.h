#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace smat::test {

/// A writer of one kind of file: writes the first or the second content.
struct Writer {
    const char* name;
    const char* file;
    std::function<void(const std::filesystem::path& file, bool second)> write;
    /// What a file holds, however its bytes are arranged.
    std::function<std::string(const std::filesystem::path& file)> content;
    bool replaces = true;                  ///< false: what stands is never touched
    std::set<std::string> companions = {}; ///< files that it makes beside
};

/// Those that stand for a way of writing each: bytes, a stream of them, a database in place.
const std::vector<Writer>& waysOfWriting();
/// All others that the program has.
const std::vector<Writer>& otherWriters();

} // namespace smat::test
