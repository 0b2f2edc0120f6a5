#pragma once

#include <filesystem>
#include <vector>

namespace irsg {

/// What a process may still look at.
struct ReadablePlaces {
    std::vector<std::filesystem::path> read;   ///< files, and folders with all below them
    std::vector<std::filesystem::path> listed; ///< folders whose names it may see
};

/// From here on this process opens only these places and what programs are made of: the folders of
/// libraries. Nothing can be written, made or removed. Where the kernel has no Landlock (before
/// 5.13, or switched off) nothing is changed: false.
bool confineFiles(const ReadablePlaces& places);

} // namespace irsg
