#include "tools/samples/FlightWriter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

#include "irsg/core/Errors.h"
#include "irsg/geometry/flight/FlightRecords.h"

namespace smat {
namespace {

namespace flight = irsg::flight;

constexpr std::int32_t version = 1610;
constexpr std::uint32_t packedColours = 0x10000000;
constexpr std::size_t longestPayload = 65528;

/// The payload of a record, field by field, big endian.
class Payload {
  public:
    template <std::integral Integer>
    Payload& put(Integer value) {
        const auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
        for (std::size_t i = sizeof bits; i-- > 0;)
            bytes_ += static_cast<char>(bits >> (8 * i) & 0xFF);
        return *this;
    }
    Payload& put(float value) { return put(std::bit_cast<std::uint32_t>(value)); }
    Payload& put(double value) { return put(std::bit_cast<std::uint64_t>(value)); }
    Payload& position(const irsg::Vec3& v) { return put(v.x).put(v.y).put(v.z); }
    Payload& normal(const irsg::Vec3& v) {
        return put(static_cast<float>(v.x))
            .put(static_cast<float>(v.y))
            .put(static_cast<float>(v.z));
    }
    Payload& text(const std::string& value, std::size_t length) {
        for (std::size_t i = 0; i < length; ++i)
            bytes_ += i < value.size() && i + 1 < length ? value[i] : '\0';
        return *this;
    }
    Payload& zeros(std::size_t count) {
        bytes_.append(count, '\0');
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

std::string record(std::uint16_t opcode, const std::string& payload = {}) {
    return Payload().put(opcode).put(static_cast<std::uint16_t>(payload.size() + 4)).bytes() +
           payload;
}

std::string continued(std::uint16_t opcode, const std::string& payload) {
    std::string records = record(opcode, payload.substr(0, longestPayload));
    for (auto at = longestPayload; at < payload.size(); at += longestPayload)
        records += record(flight::continuation, payload.substr(at, longestPayload));
    return records;
}

/// Face and mesh share a layout; the mesh has four more bytes behind its name.
std::string surfacePayload(const FlightSurface& surface, bool mesh) {
    constexpr std::int16_t none = -1;
    const auto colour = 0xFF000000u | static_cast<std::uint32_t>(surface.look.blue) << 16 |
                        static_cast<std::uint32_t>(surface.look.green) << 8 | surface.look.red;
    Payload p;
    p.text(surface.name, 8).zeros(mesh ? 4 : 0);
    p.put(surface.codes.temperature).zeros(2); // relative priority
    p.put(static_cast<std::int8_t>(surface.twoSided ? 1 : 0)).zeros(1);
    p.put(none).put(none).zeros(2);           // colour names, template
    p.put(none).put(none).put(none).zeros(4); // detail texture, texture, material
    p.put(surface.codes.material);
    p.put(static_cast<std::uint16_t>(std::lround(65535.0 * surface.look.clear)));
    p.zeros(2);                                         // LOD control, line style
    p.put(packedColours).put(std::uint8_t{2}).zeros(7); // lit, one colour
    p.put(colour).put(std::uint32_t{0xFF000000});
    p.put(none).zeros(2).put(std::int32_t{-1}).put(std::int32_t{-1}).zeros(2).put(none);
    return p.bytes();
}

std::string headerRecord(const std::string& name) {
    Payload p;
    p.text(name, 8).put(version).put(std::int32_t{1}).text("written by smat-samples", 32);
    p.put(std::int16_t{1}).put(std::int16_t{1}).put(std::int16_t{1}).put(std::int16_t{1});
    p.put(std::int16_t{1}).zeros(2);            // unit multiplier, metres
    p.put(std::uint32_t{0x80000000}).zeros(56); // vertex normals are saved; projection: flat earth
    p.put(std::int16_t{1}).put(std::int16_t{1}).put(std::int32_t{100}); // double vertices
    return record(flight::header, p.zeros(324 - 4 - p.bytes().size()).bytes());
}

std::string colourPaletteRecord() {
    Payload p;
    p.zeros(128);
    for (int i = 0; i < 1024; ++i)
        p.put(std::uint32_t{0xFFFFFFFF});
    return record(flight::colourPalette, p.bytes());
}

} // namespace

FlightWriter::FlightWriter(const std::string& name) : name_(name) {}

std::uint32_t FlightWriter::paletteOffset(const FlightVertex& vertex) {
    Payload p;
    p.zeros(2).put(std::uint16_t{0x2000}).position(vertex.position).normal(vertex.normal);
    p.put(std::uint32_t{0xFFFFFFFF}).put(std::int32_t{-1}).zeros(4);
    const auto offset = static_cast<std::uint32_t>(8 + palette_.size());
    const auto [place, added] = known_.emplace(p.bytes(), offset);
    if (added)
        palette_ += record(flight::vertexCN, p.bytes());
    return place->second;
}

void FlightWriter::addFace(const FlightSurface& surface, std::span<const FlightVertex> corners) {
    Payload list;
    for (const auto& corner : corners)
        list.put(paletteOffset(corner));
    geometry_ += record(flight::face, surfacePayload(surface, false)) + record(flight::pushLevel) +
                 record(flight::vertexList, list.bytes()) + record(flight::popLevel);
}

void FlightWriter::addMesh(const FlightSurface& surface, std::span<const FlightVertex> vertices,
                           std::span<const FlightPrimitive> primitives) {
    Payload pool;
    pool.put(static_cast<std::uint32_t>(vertices.size()));
    pool.put(std::uint32_t{0x80000000 | 0x10000000}); // positions and normals
    for (const auto& vertex : vertices)
        pool.position(vertex.position).normal(vertex.normal);
    geometry_ += record(flight::mesh, surfacePayload(surface, true)) +
                 continued(flight::localVertexPool, pool.bytes()) + record(flight::pushLevel);
    const bool narrow = vertices.size() <= 0x10000;
    for (const auto& [kind, indices] : primitives) {
        Payload p;
        p.put(static_cast<std::int16_t>(kind)).put(static_cast<std::uint16_t>(narrow ? 2 : 4));
        p.put(static_cast<std::uint32_t>(indices.size()));
        for (const auto index : indices)
            narrow ? p.put(static_cast<std::uint16_t>(index)) : p.put(index);
        geometry_ += continued(flight::meshPrimitive, p.bytes());
    }
    geometry_ += record(flight::popLevel);
}

std::string FlightWriter::bytes() const {
    const auto paletteSize = Payload().put(static_cast<std::uint32_t>(8 + palette_.size()));
    return headerRecord(name_) + colourPaletteRecord() +
           record(flight::vertexPalette, paletteSize.bytes()) + palette_ +
           record(flight::pushLevel) +
           record(flight::group, Payload().text("group", 8).zeros(32).bytes()) +
           record(flight::pushLevel) +
           record(flight::object, Payload().text("object", 8).zeros(16).bytes()) +
           record(flight::pushLevel) + geometry_ + record(flight::popLevel) +
           record(flight::popLevel) + record(flight::popLevel);
}

void FlightWriter::save(const std::filesystem::path& file) const {
    std::error_code ignored;
    if (!file.parent_path().empty())
        std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream out(file, std::ios::binary);
    const auto all = bytes();
    out.write(all.data(), static_cast<std::streamsize>(all.size()));
    out.flush();
    if (!out)
        throw irsg::InputError(
            {file.string(), "", "a file that cannot be written", "a place that can be written to"});
}

} // namespace smat
