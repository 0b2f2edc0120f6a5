#pragma once

#include <map>
#include <string>
#include <string_view>

namespace irsg {

/// In front of an attribute that a file would otherwise take for a word of its own.
inline constexpr std::string_view attributePrefix = "attribute.";

/// What a file that holds one plane says of it as text, a line each: "channel", "unit", "width" and
/// "height" of the plane (`plane`), and the attributes of its image.
struct AttributeText {
    std::map<std::string, std::string> plane, attributes;

    /// Takes a line "key: value"; one without a colon says nothing.
    void read(std::string_view line);
};

/// "key: value" without its line break: a backslash, a line break and a carriage return are written
/// `\\`, `\n` and `\r`, a colon in a key `\c`.
std::string attributeLine(std::string_view key, std::string_view value);
/// The same of an attribute of an image: one called channel, unit, width, height or attribute.*
/// gets `attribute.` in front, which AttributeText::read takes away again.
std::string imageAttributeLine(std::string_view key, std::string_view value);

} // namespace irsg
