// The geometry of FlightValidator: faces, meshes, their vertices, and what is attached to a node.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "irsg/scene/model/FlightValidator.h"

namespace irsg {
namespace {

constexpr std::uint32_t packedColour = 0x10000000, hidden = 0x04000000;

/// Bytes of one vertex of a local pool with these attributes: position, colour, normal, 8 layers.
std::size_t poolStride(std::uint32_t mask) {
    return (mask & 0x80000000 ? 24u : 0u) + (mask & 0x40000000 ? 4u : 0u) +
           (mask & 0x20000000 ? 4u : 0u) + (mask & 0x10000000 ? 12u : 0u) +
           8u * static_cast<std::size_t>(std::popcount(mask & 0x0FF00000));
}

/// The record with another payload, at most as long as its own.
std::string withPayload(const FlightRecord& record, const std::string& payload) {
    std::string bytes(record.bytes.substr(0, 4));
    const auto length = payload.size() + 4;
    bytes[2] = static_cast<char>(length >> 8 & 0xFF);
    bytes[3] = static_cast<char>(length & 0xFF);
    return bytes + payload;
}

} // namespace

bool FlightValidator::visitAncillary(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::longId:
        keep(record);
        if (current_ && current_->face >= 0)
            file_.faces[static_cast<std::size_t>(current_->face)].id =
                record.text(4, record.size() - 4);
        return true;
    case flight::comment:
        keep(record, FlightTreatment::appearance);
        return true;
    case flight::matrix:
        matrix(record);
        return true;
    case flight::replicate:
        replicate(record);
        return true;
    case flight::multitexture:
    case flight::uvList:
        if (atLeast(record, 8))
            keep(record, FlightTreatment::appearance);
        return true;
    case 132:
        remarkOnce("132", "sets of switches have names, which are not kept");
        return true;
    case 50: // vector, bounding volumes, the separate steps of a matrix
    case 74:
    case 94:
    case 116:
    case 119:
    case flight::pushAttribute:
    case flight::popAttribute:
        return true;
    default:
        return (record.opcode >= 40 && record.opcode <= 48) || record.opcode == 51 ||
               (record.opcode >= 76 && record.opcode <= 82) ||
               (record.opcode >= 105 && record.opcode <= 110);
    }
}

void FlightValidator::matrix(const FlightRecord& record) {
    if (!atLeast(record, 68))
        return;
    for (std::size_t i = 0; i < 16; ++i)
        if (!(std::abs(record.f32(4 + 4 * i)) <= 1e9f))
            return offend(record.offset + 4 + 4 * i,
                          std::to_string(record.f32(4 + 4 * i)) + " in a matrix",
                          "a finite number within 1e9");
    for (std::size_t row = 0; row < 4; ++row)
        if (std::abs(record.f32(4 + 16 * row + 12) - (row == 3 ? 1.0f : 0.0f)) > 1e-5f)
            return offend(record.offset + 4 + 16 * row + 12, "a matrix with perspective",
                          "0, 0, 0, 1 in its last column");
    if (!current_ || current_->opcode == flight::header ||
        current_->opcode == flight::instanceReference || current_->pushed)
        remarkOnce("matrix", "the matrix at byte " + std::to_string(record.offset) +
                                 " belongs to no node that can be placed and is not used");
    keep(record);
}

void FlightValidator::replicate(const FlightRecord& record) {
    if (!atLeast(record, 6))
        return;
    if (record.i16(4) < 0)
        return offend(record.offset + 4, std::to_string(record.i16(4)) + " replications",
                      "0 or more");
    if (record.i16(4) > 0)
        file_.remarks.push_back("of the part replicated " + std::to_string(record.i16(4)) +
                                " times at byte " + std::to_string(record.offset) +
                                " only the first copy appears");
    keep(record);
}

bool FlightValidator::visitGeometry(const FlightRecord& record) {
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
        offend(record.offset,
               "a record of a version before 14 (" + flightRecordName(record.opcode) + ")",
               "records of version 14 to 16");
        return true;
    default:
        return false;
    }
}

void FlightValidator::face(const FlightRecord& record) {
    const bool mesh = record.opcode == flight::mesh;
    const std::size_t shift = mesh ? 4 : 0;
    auto& node = open(record);
    if (!atLeast(record, 64 + shift))
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
        offend(record.offset + 18 + shift, "draw type " + std::to_string(type),
               "0 to 4 or 8 to 10");
    const bool white = record.u8(19 + shift) != 0 && record.i16(28 + shift) >= 0;
    if ((flags & packedColour) == 0 && !colours_ && !white)
        offend(record.offset,
               "a " + flightRecordName(record.opcode) + " with an indexed colour and no palette",
               "a colour palette record before it");
    const auto facing = record.u8(25 + shift);
    billboards_ += facing == 2 || facing == 4;

    node.face = static_cast<int>(file_.faces.size());
    file_.steps[node.step].lightModeOffset = record.offset + 48 + shift;
    node.placements[-1] = 1;
    file_.faces.push_back(std::move(face));
}

void FlightValidator::vertexList(const FlightRecord& record) {
    // Light points have vertices, too; they are drawn as empty groups.
    if (!levels_.empty() && levels_.back().light) {
        open(record, FlightTreatment::drop);
        return;
    }
    open(record);
    const bool underFace =
        !levels_.empty() && levels_.back().face >= 0 && levels_.back().opcode == flight::face;
    if (!underFace)
        return offend(record.offset, "a vertex list", "a face above it");
    if (!hasPalette_)
        return offend(record.offset, "a vertex list", "a vertex palette before it");

    auto& face = file_.faces[static_cast<std::size_t>(levels_.back().face)];
    const std::size_t stride = record.opcode == flight::vertexList ? 4 : 8;
    if ((record.size() - 4) % stride != 0)
        offend(record.offset, "a vertex list of " + std::to_string(record.size()) + " bytes",
               "4 and a multiple of " + std::to_string(stride));
    // Offsets of one vertex each, or of a pair where the vertex morphs.
    std::string kept;
    for (std::size_t at = 4; at + stride <= record.size(); at += stride) {
        bool known = true, normal = true;
        for (std::size_t offset = at; offset < at + stride; offset += 4) {
            if (record.u32(offset) >= paletteEnd_ - paletteStart_)
                return offend(record.offset + offset,
                              "vertex offset " + std::to_string(record.u32(offset)),
                              "an offset inside the vertex palette of " +
                                  std::to_string(paletteEnd_ - paletteStart_) + " bytes");
            const auto vertex = vertices_.find(record.u32(offset));
            known = known && vertex != vertices_.end();
            normal = normal && known && vertex->second;
        }
        if (known) {
            kept += record.bytes.substr(at, stride);
            face.normals = face.normals && normal;
        } else
            file_.remarks.push_back("the vertex at byte " + std::to_string(record.offset + at) +
                                    " of face " + face.id +
                                    " points between the vertices of the palette and is left out");
    }
    face.vertices += static_cast<int>(kept.size() / stride);
    if (kept.size() + 4 < record.size())
        file_.steps.back().replacement = withPayload(record, kept);
}

void FlightValidator::localVertexPool(const FlightRecord& record) {
    if (!current_ || current_->opcode != flight::mesh || current_->face < 0 || current_->pushed)
        return offend(record.offset, "a local vertex pool", "a mesh directly before it");
    if (!atLeast(record, 12))
        return;
    const std::uint32_t count = record.u32(4), mask = record.u32(8);
    const std::size_t stride = poolStride(mask);
    if ((mask & 0x80000000) == 0)
        return offend(record.offset + 8, "a vertex pool without positions", "bit 0 of its mask");
    if (count > (record.size() - 12) / stride)
        return offend(record.offset + 4,
                      std::to_string(count) + " vertices of " + std::to_string(stride) +
                          " bytes in a record of " + std::to_string(record.size()),
                      "at most " + std::to_string((record.size() - 12) / stride));
    if ((mask & 0x40000000) != 0 && !colours_)
        offend(record.offset, "a vertex pool with indexed colours and no palette",
               "a colour palette record before it");
    for (std::size_t i = 0; i < count; ++i)
        coordinate(record, 12 + i * stride);

    keep(record);
    auto& face = file_.faces[static_cast<std::size_t>(current_->face)];
    current_->poolSize = count;
    face.vertices = static_cast<int>(count);
    face.normals = (mask & 0x10000000) != 0;
}

void FlightValidator::meshPrimitive(const FlightRecord& record) {
    open(record);
    if (levels_.empty() || levels_.back().opcode != flight::mesh || !levels_.back().poolSize)
        return offend(record.offset, "a mesh primitive",
                      "a mesh with a local vertex pool above it");
    if (!atLeast(record, 12))
        return;
    const int type = record.i16(4);
    const std::size_t indexSize = record.u16(6), count = record.u32(8);
    if (type < 1 || type > 4)
        offend(record.offset + 4, "primitive type " + std::to_string(type), "1 to 4");
    if (indexSize != 1 && indexSize != 2 && indexSize != 4)
        return offend(record.offset + 6, "indices of " + std::to_string(indexSize) + " bytes",
                      "1, 2 or 4");
    if (count > (record.size() - 12) / indexSize)
        return offend(record.offset + 8, std::to_string(count) + " indices",
                      "at most " + std::to_string((record.size() - 12) / indexSize) +
                          " in a record of " + std::to_string(record.size()) + " bytes");
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = 12 + i * indexSize;
        const std::uint32_t index = indexSize == 1   ? record.u8(at)
                                    : indexSize == 2 ? record.u16(at)
                                                     : record.u32(at);
        if (index >= *levels_.back().poolSize)
            return offend(record.offset + at, "vertex index " + std::to_string(index),
                          "below " + std::to_string(*levels_.back().poolSize));
    }
}

} // namespace irsg
