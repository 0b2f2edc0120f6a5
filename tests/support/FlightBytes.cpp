#include "tests/support/FlightBytes.h"
#include "tests/support/SharedMaterial.h"

#include <array>
#include <bit>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace irsg::test {
namespace {

std::string bigEndian(std::uint64_t bits, std::size_t size) {
    std::string bytes;
    for (std::size_t i = size; i-- > 0;) {
        bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
    }
    return bytes;
}

std::string name(const std::string& text) {
    return text + zeros(8 - text.size());
}

/// The file's parts in their order.
constexpr std::array<std::string SquareFile::*, 17> order{
    &SquareFile::header,     &SquareFile::colours,   &SquareFile::palette,   &SquareFile::vertices,
    &SquareFile::push,       &SquareFile::group,     &SquareFile::pushGroup, &SquareFile::object,
    &SquareFile::pushObject, &SquareFile::face,      &SquareFile::pushFace,  &SquareFile::list,
    &SquareFile::popFace,    &SquareFile::popObject, &SquareFile::popGroup,  &SquareFile::pop,
    &SquareFile::trailer};

} // namespace

std::string u8(int value) {
    return bigEndian(static_cast<std::uint64_t>(value), 1);
}
std::string i16(int value) {
    return bigEndian(static_cast<std::uint64_t>(value), 2);
}
std::string i32(std::int64_t value) {
    return bigEndian(static_cast<std::uint64_t>(value), 4);
}
std::string f32(float value) {
    return bigEndian(std::bit_cast<std::uint32_t>(value), 4);
}
std::string f64(double value) {
    return bigEndian(std::bit_cast<std::uint64_t>(value), 8);
}
std::string zeros(std::size_t count) {
    return std::string(count, '\0');
}

std::string record(int opcode, const std::string& payload) {
    return i16(opcode) + i16(static_cast<int>(payload.size()) + 4) + payload;
}

SquareFile::SquareFile() {
    colours = record(flight::colourPalette, zeros(128) + std::string(4096, '\xff'));
    palette = record(flight::vertexPalette, i32(8 + 4 * 56));
    push = pushGroup = pushObject = pushFace = record(flight::pushLevel);
    popFace = popObject = popGroup = pop = record(flight::popLevel);
    group = record(flight::group, name("group") + zeros(32));
    object = record(flight::object, name("object") + zeros(16));
    list = record(flight::vertexList, i32(8) + i32(64) + i32(120) + i32(176));
    remake();
}

void SquareFile::remake() {
    header = record(flight::header, name("db") + i32(version) + zeros(46) + u8(unit) + zeros(257));
    vertices.clear();
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}) {
        vertices +=
            record(flight::vertexCN, i16(0) + i16(0x2000) + f64(x) + f64(y) + f64(0) + f32(0) +
                                         f32(0) + f32(1) + i32(-1) + i32(-1) + i32(0));
    }
    face = record(flight::face, name("face") + i32(temperature) + i16(0) + u8(drawType) + u8(0) +
                                    i16(-1) + i16(-1) + i16(0) + i16(-1) + i16(-1) + i16(-1) +
                                    i16(0) + i16(0) + i32(material) + i16(0) + i16(0) + i32(flags) +
                                    u8(lightMode) + zeros(7) + i32(0xFF0000FF) + i32(0) + i16(-1) +
                                    i16(0) + i32(-1) + i32(-1) + i16(0) + i16(-1));
}

std::string SquareFile::bytes() const {
    std::string all;
    for (const auto part : order) {
        all += this->*part;
    }
    return all;
}

std::size_t SquareFile::offsetOf(std::string SquareFile::*wanted) const {
    std::size_t offset = 0;
    for (const auto part : order) {
        if (part == wanted) {
            return offset;
        }
        offset += (this->*part).size();
    }
    return offset;
}

std::string SquareFile::positionOf(std::string SquareFile::*part, std::size_t within) const {
    return "byte " + std::to_string(offsetOf(part) + within);
}

std::string primitiveRecord(int type, int indexSize, std::uint32_t count,
                            const std::vector<int>& indices) {
    std::string payload = i16(type) + i16(indexSize) + i32(count);
    for (const int index : indices) {
        payload += i16(index);
    }
    return record(flight::meshPrimitive, payload);
}

std::string meshRecords(std::uint32_t count, std::uint32_t mask, const std::string& primitive) {
    std::string pool = i32(count) + i32(mask);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        pool += f64(x) + f64(y) + f64(0) + f32(0) + f32(0) + f32(1);
    }
    const std::string mesh = name("mesh") + i32(0) + i32(7) + zeros(8) + zeros(2) +
                             std::string(6, '\xff') + i16(0) + i16(0) + i32(8) + i16(0) + i16(0) +
                             i32(0x10000000) + u8(2) + zeros(7) + i32(-1) + i32(0) + i16(-1) +
                             i16(0) + i32(-1) + i32(-1) + i16(0) + i16(-1);
    return record(flight::mesh, mesh) + record(flight::localVertexPool, pool) +
           record(flight::pushLevel) +
           (primitive.empty() ? primitiveRecord(4, 2, 4, {0, 1, 2, 3}) : primitive) +
           record(flight::popLevel);
}

std::filesystem::path TemporaryFolder::write(const std::string& name,
                                             const std::string& bytes) const {
    const auto file = path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

std::string readBytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::filesystem::path sharedModels() {
    return smat::test::sharedMaterial("models");
}

} // namespace irsg::test
