#pragma once

#include <filesystem>
#include <vector>

#include <QString>

namespace smat::gui {

/// A folder that belongs to the program ("samples", "docs/user-guide"): below SMAT_DATA where that
/// is set, below share/smat of an installed program, or in the source tree that it was built from.
/// Empty where it is nowhere.
std::filesystem::path dataFolder(const std::filesystem::path& name);

/// A project that comes with the program.
struct Sample {
    QString title;                 ///< "Patrol aircraft"
    QString words;                 ///< what it is good for, one line
    std::filesystem::path project; ///< its .smat
    std::filesystem::path picture;
};
/// Those that are there, the one to begin with first.
std::vector<Sample> samples();

} // namespace smat::gui
