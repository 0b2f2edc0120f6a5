#pragma once

#include <filesystem>
#include <functional>

namespace smat::gui::test {

/// Writes a small project of the ship sample into a folder: an image of 64 x 48 pixels.
std::filesystem::path writeSampleProject(const std::filesystem::path& folder);

/// Lets events through until `done`, at most `seconds`.
bool waitUntil(const std::function<bool()>& done, double seconds = 60.0);

} // namespace smat::gui::test
