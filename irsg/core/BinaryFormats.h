#pragma once

#include <string_view>

namespace irsg {

/// A format of files that are no text, known by how they begin.
struct BinaryFormat {
    std::string_view beginning;
    std::string_view words; ///< with its article: "a PNG picture"
    bool isPicture;         ///< holds colours
};

/// The format that a file begins as, of those that people name by mistake where a text or an image
/// is read; none for others.
const BinaryFormat* binaryFormatOf(std::string_view bytes);

/// What to say of a file that holds a zero byte: its format, or "a NUL byte".
std::string_view foundInPlaceOfText(std::string_view bytes);

} // namespace irsg
