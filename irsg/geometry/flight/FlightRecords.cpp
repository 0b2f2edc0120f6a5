#include "irsg/geometry/flight/FlightRecords.h"

#include <bit>
#include <map>
#include <optional>

namespace irsg {
namespace {

constexpr std::size_t headerSize = 4;
/// Some early files end in a pop level record of the other byte order.
constexpr std::uint16_t swappedPopLevel = 0x0B00, swappedPopLength = 0x0400;

template <typename Unsigned>
Unsigned bigEndian(std::string_view bytes, std::size_t at) {
    if (at + sizeof(Unsigned) > bytes.size())
        throw LogicError("an OpenFlight field is read beyond the end of its record");
    Unsigned value = 0;
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
        value = static_cast<Unsigned>(value << 8 | static_cast<unsigned char>(bytes[at + i]));
    return value;
}

bool onlyZeros(std::string_view bytes) {
    return bytes.find_first_not_of('\0') == std::string_view::npos;
}

/// What is wrong with a record of this header and so many bytes left in the file.
std::optional<Diagnostic> brokenHeader(std::uint16_t opcode, std::size_t length, std::size_t left) {
    const auto record =
        "a " + flightRecordName(opcode) + " record of length " + std::to_string(length);
    if (left < headerSize)
        return Diagnostic{"", "", "a record header of " + std::to_string(left) + " bytes",
                          "4 bytes: the file is truncated"};
    if (length < headerSize)
        return Diagnostic{"", "", record, "a length of at least 4"};
    if (length > left)
        return Diagnostic{"", "",
                          record + " with " + std::to_string(left) + " bytes left in the file",
                          "the whole record: the file is truncated"};
    return std::nullopt;
}

} // namespace

std::uint8_t FlightRecord::u8(std::size_t at) const {
    if (at >= bytes.size())
        throw LogicError("an OpenFlight field is read beyond the end of its record");
    return static_cast<std::uint8_t>(bytes[at]);
}
std::uint16_t FlightRecord::u16(std::size_t at) const {
    return bigEndian<std::uint16_t>(bytes, at);
}
std::uint32_t FlightRecord::u32(std::size_t at) const {
    return bigEndian<std::uint32_t>(bytes, at);
}
std::int16_t FlightRecord::i16(std::size_t at) const {
    return static_cast<std::int16_t>(u16(at));
}
std::int32_t FlightRecord::i32(std::size_t at) const {
    return static_cast<std::int32_t>(u32(at));
}
float FlightRecord::f32(std::size_t at) const {
    return std::bit_cast<float>(u32(at));
}
double FlightRecord::f64(std::size_t at) const {
    return std::bit_cast<double>(bigEndian<std::uint64_t>(bytes, at));
}

std::string FlightRecord::text(std::size_t at, std::size_t length) const {
    if (at >= bytes.size())
        return {};
    const auto field = bytes.substr(at, length);
    return std::string(field.substr(0, field.find('\0')));
}

FlightRecords::FlightRecords(std::string_view bytes, const std::string& file,
                             std::vector<Diagnostic>& diagnostics) {
    std::size_t at = 0;
    int level = 0;

    while (at < bytes.size()) {
        // The header says what the record is and how long; zeros to the end are padding.
        const auto rest = bytes.substr(at);
        if (onlyZeros(rest.substr(0, headerSize)) && onlyZeros(rest))
            break;
        std::uint16_t opcode = rest.size() < headerSize ? 0 : bigEndian<std::uint16_t>(rest, 0);
        std::size_t length = rest.size() < headerSize ? 0 : bigEndian<std::uint16_t>(rest, 2);
        if (opcode == swappedPopLevel && length == swappedPopLength) {
            opcode = flight::popLevel;
            length = headerSize;
        }
        if (auto broken = brokenHeader(opcode, length, rest.size())) {
            broken->file = file;
            broken->position = "byte " + std::to_string(at);
            diagnostics.push_back(*broken);
            break;
        }

        // A continuation belongs to the record before it.
        if (opcode == flight::continuation && !records_.empty()) {
            auto& previous = records_.back();
            if (joined_.empty() || previous.bytes.data() != joined_.back().data())
                joined_.emplace_back(previous.bytes);
            joined_.back().append(bytes.substr(at + headerSize, length - headerSize));
            previous.bytes = joined_.back();
            previous.fileLength += length;
        } else {
            records_.push_back({at, opcode, length, bytes.substr(at, length)});
        }
        at += length;

        // The pop that closes the first level ends the database.
        level += opcode == flight::pushLevel ? 1 : opcode == flight::popLevel ? -1 : 0;
        if (opcode == flight::popLevel && level <= 0)
            break;
    }
    end_ = at;
}

std::size_t flightPoolStride(std::uint32_t mask) {
    return (mask & 0x80000000 ? 24u : 0u) + (mask & 0x40000000 ? 4u : 0u) +
           (mask & 0x20000000 ? 4u : 0u) + (mask & 0x10000000 ? 12u : 0u) +
           8u * static_cast<std::size_t>(std::popcount(mask & 0x0FF00000));
}

std::string flightRecordName(std::uint16_t opcode) {
    static const std::map<std::uint16_t, std::string> names = {
        {flight::header, "header"},
        {flight::group, "group"},
        {flight::object, "object"},
        {flight::face, "face"},
        {flight::pushLevel, "push level"},
        {flight::popLevel, "pop level"},
        {flight::degreeOfFreedom, "degree of freedom"},
        {flight::pushSubface, "push subface"},
        {flight::popSubface, "pop subface"},
        {flight::continuation, "continuation"},
        {flight::colourPalette, "colour palette"},
        {flight::longId, "long ID"},
        {flight::matrix, "matrix"},
        {flight::replicate, "replicate"},
        {flight::instanceReference, "instance reference"},
        {flight::instanceDefinition, "instance definition"},
        {flight::externalReference, "external reference"},
        {flight::texturePalette, "texture palette"},
        {flight::vertexPalette, "vertex palette"},
        {flight::vertexC, "vertex"},
        {flight::vertexCN, "vertex with normal"},
        {flight::vertexCNT, "vertex with normal and texture"},
        {flight::vertexCT, "vertex with texture"},
        {flight::vertexList, "vertex list"},
        {flight::levelOfDetail, "level of detail"},
        {flight::mesh, "mesh"},
        {flight::localVertexPool, "local vertex pool"},
        {flight::meshPrimitive, "mesh primitive"},
        {flight::morphVertexList, "morph vertex list"},
        {flight::switchNode, "switch"},
        {flight::materialPalette, "material palette"}};
    const auto found = names.find(opcode);
    return found != names.end() ? found->second : "opcode " + std::to_string(opcode);
}

} // namespace irsg
