#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/project/Project.h"

namespace smat {

inline constexpr int projectFileVersion = 1;

/// Reads a `.smat` file: JSON with `version`, `title`, `notes`, `results`, `models`, one object for
/// each section of settings, and `analyses`. Throws InputError with every diagnostic at once, each
/// with its key path and line, the value and what was expected. A file of a newer version is
/// refused. Keys this version does not know are kept. Files that the project names are looked at by
/// SceneBuilder, not here. `remarks`, where it is given, gets one sentence for each former name of
/// a setting or value in the file.
Project loadProject(const std::filesystem::path& file, std::vector<std::string>* remarks = nullptr);
/// The same from memory, as if the text stood in `file`.
Project projectFromJson(const std::string& text, const std::filesystem::path& file,
                        std::vector<std::string>* remarks = nullptr);

/// Sorted keys, defaults omitted, unknown keys kept, paths relative to `file`'s folder where they
/// lie in or beside it. Equal projects give equal text.
std::string projectToJson(const Project& project, const std::filesystem::path& file);
/// Writes it whole or not at all. Throws InputError where the file cannot be written.
void saveProject(const Project& project, const std::filesystem::path& file);

/// Key paths of the keys this version does not know, for a warning: "sensor.widht".
std::vector<std::string> unknownKeys(const Project& project);
/// The end of that warning, didYouMean() for such a path: of a key in a section of settings the
/// settings, else the keys that may stand there.
std::string knownKeysLike(const std::string& path);

} // namespace smat
