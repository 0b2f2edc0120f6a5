#pragma once

#include <string>

#include "smatcore/project/Project.h"

namespace smat {

/// Options that give a command the settings `now` where it would have `known`, each with a blank
/// before it; of the analyses' own settings those of `kind` alone. `--set key=value` for every one
/// where `assigned`. Paths are those that `project` resolves.
std::string settingOptions(const Project& project, const Settings& now, const Settings& known,
                           AnalysisKind kind, bool assigned = false);

} // namespace smat
