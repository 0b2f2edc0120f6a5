#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"

namespace smat::batch {

/// What `mtf info --json` prints: fields with value (null where unknown) and unit, curves, notes.
nlohmann::ordered_json mtfAsJson(const std::string& file);

/// Adds `mtf build` below `mtf`. A build without irsg/scattering has a command of this name that
/// says so.
void addMtfBuildCommand(CLI::App& mtf, Context& context);

} // namespace smat::batch
