#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace irsg {

/// The text of a model as readers take it: in UTF-8 without a byte order mark, its lines ended by
/// LF. A text that begins with the mark of UTF-16 or UTF-32 is converted; CR and CR LF become LF,
/// and so the numbers of lines stay; the end mark of DOS (0x1A) is cut off. Other bytes stay as
/// they are. `file` is used in messages. Throws InputError for UTF-16 or UTF-32 that ends within a
/// character or has one that there is not.
std::string plainText(std::string bytes, const std::string& file);

/// Whether these bytes begin with a byte order mark.
bool hasMark(std::string_view bytes);

/// The bytes of a model of one of the formats that are texts, or have a form that is one, by the
/// extension of `file`: plainText() of a text, any other file as it is. They are read from `place`.
/// Throws InputError as readFile() and plainText() do.
std::string readModelBytes(const std::filesystem::path& place, const std::filesystem::path& file);

/// Whether the models of this extension (lower case, without its dot) are texts, or can be.
bool hasTextForm(std::string_view extension);

} // namespace irsg
