#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Writes one plane as comma separated values: a `# key: value` line for the channel, its unit, the
/// size and each attribute, then one line a row, top row first, 9 significant digits (a float comes
/// back bit for bit), `nan`, `inf` and `-inf` as such. In keys and values a backslash, a line break
/// and a carriage return become `\\`, `\n` and `\r`, a colon in a key `\c`; an attribute called
/// channel, unit, width, height or attribute.* gets `attribute.` in front.
/// `channel` empty: the shown plane. Throws InputError where the file cannot be written, LogicError
/// for an empty image or an unknown channel.
void writeCsvImage(const RadianceImage& image, const std::filesystem::path& file,
                   const std::string& channel = "");

/// Reads what writeCsvImage wrote, and plain matrices (report SMAT and KARMA images: no header):
/// numbers separated by commas, semicolons, tabs or blanks, one row a line, top row first; a
/// separator at the end of a line is allowed, blank lines are skipped. A plane without a name is
/// `L`, without a unit. Throws InputError with every diagnostic (the first 20) at its line and
/// column: rows of different length, text that is no number, a number beyond the range of float, a
/// size that is not what the header says; and for a file without a number. A text that begins with
/// words, such as a table of results with the names of its columns, is refused in one sentence.
RadianceImage readCsvImage(const std::filesystem::path& file);

/// Whether the beginning of a text is that of an image: a header of writeCsvImage, or a first row
/// that begins with a number where a table has the names of its columns.
bool beginsAsCsvImage(std::string_view text);

} // namespace irsg
