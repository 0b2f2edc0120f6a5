#include "irsg/geometry/flight/FlightGeometry.h"

#include <utility>

namespace irsg {
namespace {

constexpr std::uint32_t packedColour = 0x10000000, hidden = 0x04000000;

/// The record with another payload, at most as long as its own.
std::string withPayload(const FlightRecord& record, const std::string& payload) {
    std::string bytes(record.bytes.substr(0, 4));
    const auto length = payload.size() + 4;
    bytes[2] = static_cast<char>(length >> 8 & 0xFF);
    bytes[3] = static_cast<char>(length & 0xFF);
    return bytes + payload;
}

} // namespace

bool FlightGeometry::visit(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::face:
    case flight::mesh:
        face(record);
        return true;
    case flight::vertexList:
    case flight::morphVertexList:
        vertexList(record);
        return true;
    case flight::localVertexPool:
        localVertexPool(record);
        return true;
    case flight::meshPrimitive:
        meshPrimitive(record);
        return true;
    case 3: // level of detail and vertices of versions before 13
    case 7:
    case 8:
    case 9:
        log_.report(record.offset,
                    "a record of a version before 14 (" + flightRecordName(record.opcode) + ")",
                    "records of version 14 to 16");
        return true;
    default:
        return false;
    }
}

void FlightGeometry::face(const FlightRecord& record) {
    const bool mesh = record.opcode == flight::mesh;
    const std::size_t shift = mesh ? 4 : 0;
    auto& node = levels_.open(record);
    if (!log_.atLeast(record, 64 + shift))
        return;

    FlightFace face;
    face.offset = record.offset;
    face.id = record.text(4, 8);
    face.codes = {record.i32(12 + shift), record.i32(36 + shift)};
    face.mesh = mesh;
    face.drawType = static_cast<std::int8_t>(record.u8(18 + shift));
    const auto flags = record.u32(44 + shift);
    face.hidden = (flags & hidden) != 0;
    face.normals = true;

    const int type = face.drawType;
    if (!((type >= 0 && type <= 4) || (type >= 8 && type <= 10)))
        log_.report(record.offset + 18 + shift, "draw type " + std::to_string(type),
                    "0 to 4 or 8 to 10");
    const bool white = record.u8(19 + shift) != 0 && record.i16(28 + shift) >= 0;
    if ((flags & packedColour) == 0 && !hasColours_ && !white)
        log_.report(record.offset,
                    "a " + flightRecordName(record.opcode) +
                        " with an indexed colour and no palette",
                    "a colour palette record before it");
    const auto facing = record.u8(25 + shift);
    billboards_ += facing == 2 || facing == 4;

    node.face = static_cast<int>(log_.file().faces.size());
    log_.file().steps[node.step].lightModeOffset = record.offset + 48 + shift;
    node.placements[-1] = 1;
    log_.file().faces.push_back(std::move(face));
}

void FlightGeometry::vertexList(const FlightRecord& record) {
    FlightLevels::Node* const parent = levels_.parent();
    // Light points have vertices, too; they are drawn as empty groups.
    if (parent != nullptr && parent->light) {
        levels_.open(record, FlightTreatment::drop);
        return;
    }
    levels_.open(record);
    const bool underFace = parent != nullptr && parent->face >= 0 && parent->opcode == flight::face;
    if (!underFace)
        return log_.report(record.offset, "a vertex list", "a face above it");
    if (!palette_.isThere())
        return log_.report(record.offset, "a vertex list", "a vertex palette before it");

    auto& face = log_.file().faces[static_cast<std::size_t>(parent->face)];
    const std::size_t stride = record.opcode == flight::vertexList ? 4 : 8;
    if ((record.size() - 4) % stride != 0)
        log_.report(record.offset, "a vertex list of " + std::to_string(record.size()) + " bytes",
                    "4 and a multiple of " + std::to_string(stride));
    // Offsets of one vertex each, or of a pair where the vertex morphs.
    std::string kept;
    for (std::size_t at = 4; at + stride <= record.size(); at += stride) {
        bool known = true, normal = true;
        for (std::size_t offset = at; offset < at + stride; offset += 4) {
            if (record.u32(offset) >= palette_.size())
                return log_.report(record.offset + offset,
                                   "vertex offset " + std::to_string(record.u32(offset)),
                                   "an offset inside the vertex palette of " +
                                       std::to_string(palette_.size()) + " bytes");
            const auto hasNormal = palette_.hasNormal(record.u32(offset));
            known = known && hasNormal;
            normal = normal && hasNormal.value_or(false);
        }
        if (known) {
            kept += record.bytes.substr(at, stride);
            face.normals = face.normals && normal;
        } else
            log_.remark("the vertex at byte " + std::to_string(record.offset + at) + " of face " +
                        face.id + " points between the vertices of the palette and is left out");
    }
    face.vertices += static_cast<int>(kept.size() / stride);
    if (kept.size() + 4 < record.size())
        log_.file().steps.back().replacement = withPayload(record, kept);
}

void FlightGeometry::localVertexPool(const FlightRecord& record) {
    FlightLevels::Node* const current = levels_.current();
    if (current == nullptr || current->opcode != flight::mesh || current->face < 0 ||
        current->pushed)
        return log_.report(record.offset, "a local vertex pool", "a mesh directly before it");
    if (!log_.atLeast(record, 12))
        return;
    const std::uint32_t count = record.u32(4), mask = record.u32(8);
    const std::size_t stride = flightPoolStride(mask);
    if ((mask & 0x80000000) == 0)
        return log_.report(record.offset + 8, "a vertex pool without positions",
                           "bit 0 of its mask");
    if (count > (record.size() - 12) / stride)
        return log_.report(record.offset + 4,
                           std::to_string(count) + " vertices of " + std::to_string(stride) +
                               " bytes in a record of " + std::to_string(record.size()),
                           "at most " + std::to_string((record.size() - 12) / stride));
    if ((mask & 0x40000000) != 0 && !hasColours_)
        log_.report(record.offset, "a vertex pool with indexed colours and no palette",
                    "a colour palette record before it");
    for (std::size_t i = 0; i < count; ++i)
        log_.coordinate(record, 12 + i * stride);

    log_.keep(record);
    auto& face = log_.file().faces[static_cast<std::size_t>(current->face)];
    current->poolSize = count;
    face.vertices = static_cast<int>(count);
    face.normals = (mask & 0x10000000) != 0;
}

void FlightGeometry::meshPrimitive(const FlightRecord& record) {
    levels_.open(record);
    const FlightLevels::Node* const parent = levels_.parent();
    if (parent == nullptr || parent->opcode != flight::mesh || !parent->poolSize)
        return log_.report(record.offset, "a mesh primitive",
                           "a mesh with a local vertex pool above it");
    if (!log_.atLeast(record, 12))
        return;
    const int type = record.i16(4);
    const std::size_t indexSize = record.u16(6), count = record.u32(8);
    if (type < 1 || type > 4)
        log_.report(record.offset + 4, "primitive type " + std::to_string(type), "1 to 4");
    if (indexSize != 1 && indexSize != 2 && indexSize != 4)
        return log_.report(record.offset + 6, "indices of " + std::to_string(indexSize) + " bytes",
                           "1, 2 or 4");
    if (count > (record.size() - 12) / indexSize)
        return log_.report(record.offset + 8, std::to_string(count) + " indices",
                           "at most " + std::to_string((record.size() - 12) / indexSize) +
                               " in a record of " + std::to_string(record.size()) + " bytes");
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = 12 + i * indexSize;
        const std::uint32_t index = indexSize == 1   ? record.u8(at)
                                    : indexSize == 2 ? record.u16(at)
                                                     : record.u32(at);
        if (index >= *parent->poolSize)
            return log_.report(record.offset + at, "vertex index " + std::to_string(index),
                               "below " + std::to_string(*parent->poolSize));
    }
}

void FlightGeometry::finish() {
    if (billboards_ > 0)
        log_.remark(std::to_string(billboards_) +
                    " billboard faces do not turn towards the sensor");
}

} // namespace irsg
