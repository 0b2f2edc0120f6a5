#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/simulate/Scenario.h"

namespace smat {

inline constexpr int scenarioFileVersion = 1;
/// More steps than any engagement has, and than six digits of a frame's number can count.
inline constexpr double mostSteps = 1e6;

/// Reads a scenario: JSON with `version`, `title`, `notes`, `dt_s`, `start_s`, `end_s`, sections of
/// settings, `entities` and `sensors` (docs/formats-scenario.md). Throws InputError with every
/// diagnostic at once, each with its key path and line, the value and what was expected; a key that
/// is not known is one. Files that the scenario names are looked at by SceneGenerator3D, not here.
/// `remarks`, where it is given, gets one sentence for each former name of a setting in the file.
Scenario loadScenario(const std::filesystem::path& file,
                      std::vector<std::string>* remarks = nullptr);
/// The same from memory, as if the text stood in `file`.
Scenario scenarioFromJson(const std::string& text, const std::filesystem::path& file,
                          std::vector<std::string>* remarks = nullptr);

/// Whether a file is a scenario (JSON with entities, sensors or steps); not whether it is a sound
/// one.
bool isScenarioFile(const std::filesystem::path& file);

/// Sorted keys, defaults omitted, paths relative to `file`'s folder where they lie in or beside it.
/// Equal scenarios give equal text.
std::string scenarioToJson(const Scenario& scenario, const std::filesystem::path& file);
/// Writes it whole or not at all. Throws InputError where the file cannot be written.
void saveScenario(const Scenario& scenario, const std::filesystem::path& file);

} // namespace smat
