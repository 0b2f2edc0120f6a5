#pragma once

#include <filesystem>
#include <string>

#include <QWidget>

namespace smat::gui::test {

/// Keeps a picture of a window for a person to look at: screenshots/NAME.png in the build folder.
void keepScreenshot(QWidget& widget, const std::string& name);

/// A folder of its own for each test, emptied first.
std::filesystem::path freshFolder(const std::string& name);

} // namespace smat::gui::test
