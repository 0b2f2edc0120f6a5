#pragma once

#include <filesystem>
#include <string>

namespace smat {

/// Makes a folder and those above it where they are missing. Throws InputError, which expects
/// "a folder for " and `what`, where none can be made.
void makeFolder(const std::filesystem::path& folder, const std::string& what);

} // namespace smat
