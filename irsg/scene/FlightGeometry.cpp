// The records of FlightValidator that carry geometry, palettes and nodes.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "irsg/scene/FlightValidator.h"

namespace irsg {
namespace {

constexpr std::uint32_t packedColour = 0x10000000, hidden = 0x04000000;

/// Bytes a vertex of the palette needs so that position, normal and packed colour are its own.
std::size_t vertexSize(std::uint16_t opcode) {
    switch (opcode) {
    case flight::vertexCN:
        return 48;
    case flight::vertexCNT:
        return 56;
    case flight::vertexCT:
        return 44;
    default:
        return 36;
    }
}

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

bool FlightValidator::visitPalette(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::colourPalette:
        if (atLeast(record, 136)) {
            keep(record);
            colours_ = true;
        }
        return true;
    case flight::vertexPalette:
        vertexPalette(record);
        return true;
    case flight::vertexC:
    case flight::vertexCN:
    case flight::vertexCNT:
    case flight::vertexCT:
        paletteVertex(record);
        return true;
    case flight::texturePalette:
        if (atLeast(record, 208))
            keep(record, FlightTreatment::appearance);
        return true;
    case flight::materialPalette:
        if (atLeast(record, 80))
            keep(record, FlightTreatment::appearance);
        return true;
    case flight::oldMaterialPalette:
        keep(record, FlightTreatment::appearance);
        return true;
    case 83: // eyepoints, linkage, sounds, line styles, light sources, texture mappings, names
    case 90:
    case 93:
    case 97:
    case 102:
    case 112:
    case flight::nameTable:
    case 128: // appearance and animation of light points, shaders, extended materials
    case 129:
        return true;
    default:
        return record.opcode >= 133 && record.opcode <= 149;
    }
}

void FlightValidator::vertexPalette(const FlightRecord& record) {
    if (!atLeast(record, 8))
        return;
    const std::size_t size = record.u32(4);
    if (record.size() != 8 || size < 8 || size > file_.bytes.size() - record.offset)
        return offend(record.offset + 4,
                      "a vertex palette of " + std::to_string(size) + " bytes in a record of " +
                          std::to_string(record.size()),
                      "8 to " + std::to_string(file_.bytes.size() - record.offset) +
                          " bytes, the vertices following a record of 8");
    keep(record);
    vertices_.clear();
    hasPalette_ = inPalette_ = true;
    paletteStart_ = record.offset;
    paletteEnd_ = record.offset + size;
}

void FlightValidator::paletteVertex(const FlightRecord& record) {
    if (!inPalette_ || record.offset + record.size() > paletteEnd_)
        return offend(record.offset, "a vertex record outside the vertex palette",
                      "vertices within the length the palette states");
    if (!atLeast(record, vertexSize(record.opcode)))
        return;
    keep(record);
    coordinate(record, 8);
    const bool normal = record.opcode == flight::vertexCN || record.opcode == flight::vertexCNT;
    vertices_[static_cast<std::uint32_t>(record.offset - paletteStart_)] = normal;
}

void FlightValidator::checkPaletteEnd(std::size_t at) {
    if (inPalette_ && std::exchange(inPalette_, false) && at != paletteEnd_ && at != paletteStart_)
        offend(paletteStart_ + 4,
               "a vertex palette that ends at byte " + std::to_string(paletteEnd_),
               "byte " + std::to_string(at) + ", where its vertices end");
}

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
    case 50: // vector, bounding volumes, the separate steps of a matrix, switch names
    case 74:
    case 94:
    case 116:
    case 119:
    case flight::pushAttribute:
    case flight::popAttribute:
    case 132:
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

bool FlightValidator::visitNode(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::group:
    case flight::object:
        atLeast(record, 12);
        open(record);
        return true;
    case flight::degreeOfFreedom:
        open(record);
        if (atLeast(record, 380))
            finite(record, 16, 9 + 36);
        return true;
    case flight::levelOfDetail:
        open(record);
        if (atLeast(record, 64))
            finite(record, 16, 2), finite(record, 40, 3);
        return true;
    case flight::switchNode:
        switchNode(record);
        return true;
    case flight::instanceDefinition:
    case flight::instanceReference:
        instance(record);
        return true;
    case flight::externalReference:
        external(record);
        return true;
    case flight::lightSource:
    case flight::lightPoint:
    case flight::indexedLightPoint:
    case flight::lightPointSystem:
        remarkOnce("light", "light sources and light points have no infrared codes: not drawn");
        open(record, FlightTreatment::asGroup).light = true;
        return true;
    case flight::separatingPlane:
    case flight::extension:
    case flight::roadSegment:
    case flight::roadPath:
    case flight::roadConstruction:
        open(record, FlightTreatment::asGroup);
        return true;
    case flight::sound:
    case flight::text:
    case flight::clipRegion:
    case flight::curve:
    case flight::continuouslyAdaptiveTerrain:
        remarkOnce(std::to_string(record.opcode),
                   "sounds, texts, clip regions, curves and adaptive "
                   "terrain are not drawn");
        open(record, FlightTreatment::asGroup).light = true;
        return true;
    default:
        return false;
    }
}

void FlightValidator::switchNode(const FlightRecord& record) {
    auto& node = open(record);
    if (!atLeast(record, 28))
        return;
    const std::uint32_t present = record.u32(16), masks = record.u32(20), words = record.u32(24);
    if (masks == 0 || words == 0 || masks > record.size() || words > record.size() ||
        std::size_t{masks} * words > (record.size() - 28) / 4)
        return offend(record.offset + 20,
                      std::to_string(masks) + " switch masks of " + std::to_string(words) +
                          " words in a record of " + std::to_string(record.size()) + " bytes",
                      "one mask of one word or more, all inside the record");
    if (present >= masks)
        offend(record.offset + 16, "switch mask " + std::to_string(present),
               "below " + std::to_string(masks));
    node.childLimit = 32 * std::size_t{words};
}

void FlightValidator::instance(const FlightRecord& record) {
    auto& node = open(record);
    if (!atLeast(record, 8))
        return;
    node.number = record.u16(6);
    if (record.opcode == flight::instanceDefinition)
        return;
    const auto found = instances_.find(node.number);
    if (found == instances_.end())
        return offend(record.offset + 6, "a reference to instance " + std::to_string(node.number),
                      "its definition before it");
    node.placements = found->second.placements;
    node.height = found->second.height + 1;
}

void FlightValidator::external(const FlightRecord& record) {
    auto& node = open(record);
    if (!atLeast(record, 204))
        return;
    const auto path = record.text(4, 200);
    if (path.empty())
        return offend(record.offset + 4, "an external reference without a path", "a file name");

    // Bit 0 of the mask keeps the palette of the other file.
    const std::uint32_t mask = record.size() >= 212 ? record.u32(208) : 0xFFFFFFFF;
    const bool own = (mask & 0x80000000) != 0 || file_.version == 1541 || file_.version < 1420;
    node.placements[static_cast<int>(file_.externals.size())] = 1;
    file_.externals.push_back({record.offset, path, {}, !own && colours_, 0});
}

} // namespace irsg
