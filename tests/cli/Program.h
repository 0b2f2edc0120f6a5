#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace smat::test {

/// What a run of a program left behind.
struct Ran {
    int exitCode = -1; ///< 128 + signal where a signal ended it
    std::string out, err;
    double processor_s = 0.0; ///< with that of its children
    double peak_MB = 0.0;     ///< the most memory it had at any time, or more: see Sanitized.h
};

/// Runs smat-batch with these arguments, from `folder`. With `interruptAfter`, a signal is sent
/// once that text has appeared on standard error.
Ran smatBatch(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
              const std::string& interruptAfter = "", int signal = SIGINT);

/// The same of any program, which is words.front().
Ran runProgram(const std::vector<std::string>& words, const std::filesystem::path& folder = ".",
               const std::string& interruptAfter = "", int signal = SIGINT);

std::filesystem::path sample(const std::string& name);
std::string contentOf(const std::filesystem::path& file);
/// That of a result without the line that says by which command it was made.
std::string withoutCommand(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& content);

} // namespace smat::test
