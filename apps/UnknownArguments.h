#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace smat {

/// What is wrong with a command line that holds a command or an option that does not exist, with
/// the names nearest to it: "smat-batch: found poler, expected a command; did you mean 'polar'?
/// (smat-batch --help lists them)". `app` has tried to parse `arguments`. No value where all of
/// them are known.
std::optional<std::string> unknownArgument(const CLI::App& app,
                                           const std::vector<std::string>& arguments);

} // namespace smat
