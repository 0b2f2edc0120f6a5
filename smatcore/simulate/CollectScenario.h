#pragma once

#include <filesystem>

#include "smatcore/project/FileCollection.h"
#include "smatcore/simulate/Scenario.h"

namespace smat {

/// Copies a scenario with its models, databases, trajectories, sensors and the files of its
/// settings to a new place, and returns it. Throws InputError as FileCollection::write and
/// saveScenario do.
Scenario collectScenario(const Scenario& scenario, const std::filesystem::path& file,
                         FileCollection* told = nullptr);

} // namespace smat
