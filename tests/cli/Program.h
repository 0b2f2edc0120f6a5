#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smat::test {

/// What a run of a program left behind.
struct Ran {
    int exitCode = -1; ///< 128 + signal where a signal ended it
    std::string out, err;
};

/// Runs smat-batch with these arguments, from `folder`. With `interruptAfter`, an interrupt is sent
/// once that text has appeared on standard error.
Ran smatBatch(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
              const std::string& interruptAfter = "");

std::filesystem::path sample(const std::string& name);
std::string contentOf(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& content);

} // namespace smat::test
