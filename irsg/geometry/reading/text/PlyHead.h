#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// The head of a polygon file: what elements follow and how their numbers are written.
struct PlyHead {
    enum class Form { text, littleEndian, bigEndian };
    enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
    struct Property {
        std::string name;
        Type type = Type::float32;
        bool isList = false;
        Type count = Type::uint8; ///< of a list
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };

    Form form = Form::text;
    std::vector<Element> elements;
    std::vector<std::string> comments; ///< with the lines of obj_info
    std::size_t size_B = 0;            ///< up to the first number
    std::size_t lines = 0;             ///< in the head
};

/// Reads the head. A byte order mark before it is passed over; its lines may end in LF, CR LF or
/// CR. Throws InputError, with the line, where it is none.
PlyHead readPlyHead(std::string_view bytes, const std::string& file);

/// Bytes of a number of this type.
std::size_t sizeOf(PlyHead::Type type);

} // namespace irsg
