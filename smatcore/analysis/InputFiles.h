#pragma once

#include <compare>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/project/Project.h"

namespace smat {

/// A file, or a folder of pictures, that the numbers of an analysis follow from.
struct InputFile {
    std::string role; ///< "model", "codes", "database", "scaling", "air", or the key of a setting
    std::filesystem::path file; ///< resolved
    std::size_t number = 0;     ///< of the model, or the place in the list of the setting

    auto operator<=>(const InputFile&) const = default;
};

/// The models with the codes, the database and the scalings that lie beside them, and every file
/// that a setting names which concerns this kind of analysis; of a KARMA Environment the files it
/// is composed of, too. In the order of the project. What those files refer to in turn (textures,
/// external references) is not listed.
std::vector<InputFile> inputFilesOf(const Project& project, const Settings& settings,
                                    AnalysisKind kind);

/// Whether project or settings name the file; codes and scalings lie beside their model, and parts
/// of an Environment ("air") are named there.
bool isReplaceable(const InputFile& input);
/// Puts another file in the place of that input, which must be one of theirs and replaceable
/// (LogicError).
void replaceInput(Project& project, Settings& settings, const InputFile& input,
                  const std::filesystem::path& by);

/// The SHA-256 of a file's bytes, computed anew only where its stamp has changed. Throws InputError
/// where it cannot be read.
std::string fileHash(const std::filesystem::path& file);
/// The first 16 digits of it, of a folder those of its files by name. Empty where it cannot be
/// read.
std::string contentHash(const std::filesystem::path& file);

} // namespace smat
