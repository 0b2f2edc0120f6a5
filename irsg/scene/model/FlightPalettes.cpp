// The palettes of FlightValidator: colours, vertices, and those that only the visible display
// needs.
#include <utility>

#include "irsg/scene/model/FlightValidator.h"

namespace irsg {
namespace {

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

} // namespace irsg
