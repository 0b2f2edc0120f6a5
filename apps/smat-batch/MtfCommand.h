#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/Command.h"

namespace smat::batch {

/// Adds `mtf build` below `mtf`. A build without irsg/scattering has a command of this name that
/// says so.
void addMtfBuildCommand(CLI::App& mtf, Context& context);

} // namespace smat::batch
