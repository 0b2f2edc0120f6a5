#include "irsg/geometry/flight/FlightVertexPalette.h"

#include <utility>

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

bool FlightVertexPalette::isVertex(std::uint16_t opcode) {
    return opcode >= flight::vertexC && opcode <= flight::vertexCT;
}

void FlightVertexPalette::begin(const FlightRecord& record) {
    if (!log_.atLeast(record, 8))
        return;
    const std::size_t size = record.u32(4);
    if (record.size() != 8 || size < 8 || size > log_.file().bytes.size() - record.offset)
        return log_.report(record.offset + 4,
                           "a vertex palette of " + std::to_string(size) +
                               " bytes in a record of " + std::to_string(record.size()),
                           "8 to " + std::to_string(log_.file().bytes.size() - record.offset) +
                               " bytes, the vertices following a record of 8");
    log_.keep(record);
    vertices_.clear();
    isThere_ = isOpen_ = true;
    start_ = record.offset;
    end_ = record.offset + size;
}

void FlightVertexPalette::vertex(const FlightRecord& record) {
    if (!isOpen_ || record.offset + record.size() > end_)
        return log_.report(record.offset, "a vertex record outside the vertex palette",
                           "vertices within the length the palette states");
    if (!log_.atLeast(record, vertexSize(record.opcode)))
        return;
    log_.keep(record);
    log_.coordinate(record, 8);
    const bool normal = record.opcode == flight::vertexCN || record.opcode == flight::vertexCNT;
    vertices_[static_cast<std::uint32_t>(record.offset - start_)] = normal;
}

void FlightVertexPalette::endAt(std::size_t offset) {
    if (isOpen_ && std::exchange(isOpen_, false) && offset != end_ && offset != start_)
        log_.report(start_ + 4, "a vertex palette that ends at byte " + std::to_string(end_),
                    "byte " + std::to_string(offset) + ", where its vertices end");
}

std::optional<bool> FlightVertexPalette::hasNormal(std::uint32_t place) const {
    const auto found = vertices_.find(place);
    return found == vertices_.end() ? std::nullopt : std::optional(found->second);
}

} // namespace irsg
