#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace smat::batch {

/// Arguments of a command line whose commands and options have their names of today in place of
/// former ones: those of the kinds of analyses and tools, of settings, and of other options.
/// `remarks` gets one sentence for each that was replaced: "--former is called --previous now".
std::vector<std::string> withNamesOfToday(const CLI::App& app, std::vector<std::string> arguments,
                                          std::vector<std::string>& remarks);

} // namespace smat::batch
