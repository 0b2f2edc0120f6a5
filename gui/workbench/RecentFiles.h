#pragma once

#include <filesystem>

#include <QStringList>

namespace smat::gui {

/// Files opened before, the last one first, at most ten; windows and starts of the program share
/// them.
QStringList recentFiles();
void rememberFile(const std::filesystem::path& file);

} // namespace smat::gui
