#pragma once

#include <filesystem>
#include <string>

namespace smat {

/// Makes a folder and those above it where they are missing. Throws InputError, which expects
/// "a folder for " and `what`, where none can be made.
void makeFolder(const std::filesystem::path& folder, const std::string& what);

/// Throws InputError where makeFolder would, or where nothing could be written into the folder.
/// Changes nothing.
void checkFolder(const std::filesystem::path& folder, const std::string& what);

} // namespace smat
