#pragma once

#include <filesystem>
#include <vector>

namespace irsg {

/// From here on this process opens only what lies in `folder` or below it, the `files`, whose
/// folders it may list, and what programs are made of: the folders of libraries. Nothing can be
/// written, made or removed. Where the kernel has no Landlock (before 5.13, or switched off)
/// nothing is changed: false.
bool confineFiles(const std::filesystem::path& folder,
                  const std::vector<std::filesystem::path>& files);

} // namespace irsg
