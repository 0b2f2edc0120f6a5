#pragma once

#include <filesystem>
#include <vector>

#include <QString>

namespace smat::gui {

/// A folder that belongs to the program ("samples", "docs/user-guide"): below SMAT_DATA where that
/// is set, below share/smat of an installed program, or in the source tree that it was built from.
/// Empty where it is nowhere.
std::filesystem::path dataFolder(const std::filesystem::path& name);

/// A project or a scenario that comes with the program.
struct Sample {
    QString title;                 ///< "Patrol aircraft"
    QString words;                 ///< what it is good for, one line
    std::filesystem::path project; ///< its .smat, or the .json of a scenario
    std::filesystem::path picture;
};
/// Those that are there, the one to begin with first.
std::vector<Sample> samples();

/// Whether a file lies among the samples. They stay as they came: a save asks for another place.
bool isOfSample(const std::filesystem::path& file);
/// Throws irsg::InputError for a file that is to be written among the samples.
void requireOwnPlace(const std::filesystem::path& file);
/// Where a file may be saved: where it is; one of a sample among the person's documents.
std::filesystem::path ownPlaceOf(const std::filesystem::path& file);
/// What a copy and a lock of unsaved edits lie beside: the file; for one of a sample a name in the
/// person's own data, whose folder is made; for what has no file yet `unnamed` there.
std::filesystem::path placeForUnsaved(const std::filesystem::path& file,
                                      const std::filesystem::path& unnamed = {});

} // namespace smat::gui
