#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// A text file as lines that know their numbers, for the readers of other programs' results.
struct TextLines {
    std::string file;
    std::vector<std::string> lines; ///< without LF, CR and blanks at their ends

    /// Throws InputError where the file cannot be read, is empty, is larger than 512 MiB or is
    /// binary (a NUL byte).
    static TextLines read(const std::filesystem::path& file);
    /// The same from memory.
    static TextLines parse(std::string_view text, std::string file);

    /// About the line of an index (which counts from 0; the message counts from 1).
    Diagnostic diagnostic(std::size_t index, std::string value, std::string expected) const;
};

/// The whole of a file. Throws InputError as above.
std::string readTextFile(const std::filesystem::path& file);

/// `columns` characters of `line` from `first` on, trimmed; as many as there are.
std::string_view field(std::string_view line, std::size_t first, std::size_t columns);

/// A finite number as Fortran prints it: "1.2E-03", "1.2D-03", "1.2-103" (the E makes room for a
/// third digit), "30.". No value for anything else, "********" and "NaN" included.
std::optional<double> fortranNumber(std::string_view text);

} // namespace irsg
