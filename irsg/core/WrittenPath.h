#pragma once

#include <filesystem>
#include <string>

namespace irsg {

/// What a name that was written in a file stands for here.
struct WrittenPath {
    std::filesystem::path file; ///< or folder; empty where nothing is found
    std::string remark;         ///< "the name sub\box.flt is read as sub/box.flt", or empty
};

/// Finds what `written` names, seen from `folder` unless it is absolute: as it is written; with
/// backslashes as slashes; and with upper and lower case alike, name by name, where one entry of
/// the folder alone is meant then. So names from systems that do not tell these apart are found. A
/// name of several that differ by case alone is not guessed.
WrittenPath findWritten(const std::filesystem::path& folder, const std::string& written);

/// The same, or else the name alone, without its folders, in `folder`: for files that name others
/// by where they lay on the machine that wrote them.
WrittenPath findWrittenOrBeside(const std::filesystem::path& folder, const std::string& written);

/// The last name of a path with either kind of slash.
std::string writtenFileName(const std::string& written);

/// Whether two names are equal but for upper and lower case of ASCII letters.
bool isSameName(const std::string& one, const std::string& other);

} // namespace irsg
