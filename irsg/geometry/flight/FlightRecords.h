#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// Operation codes of the OpenFlight records that geometry is made of.
namespace flight {
enum Opcode : std::uint16_t {
    header = 1,
    group = 2,
    object = 4,
    face = 5,
    pushLevel = 10,
    popLevel = 11,
    degreeOfFreedom = 14,
    pushSubface = 19,
    popSubface = 20,
    pushExtension = 21,
    popExtension = 22,
    continuation = 23,
    comment = 31,
    colourPalette = 32,
    longId = 33,
    matrix = 49,
    multitexture = 52,
    uvList = 53,
    separatingPlane = 55,
    replicate = 60,
    instanceReference = 61,
    instanceDefinition = 62,
    externalReference = 63,
    texturePalette = 64,
    oldMaterialPalette = 66,
    vertexPalette = 67,
    vertexC = 68,
    vertexCN = 69,
    vertexCNT = 70,
    vertexCT = 71,
    vertexList = 72,
    levelOfDetail = 73,
    mesh = 84,
    localVertexPool = 85,
    meshPrimitive = 86,
    roadSegment = 87,
    morphVertexList = 89,
    sound = 91,
    roadPath = 92,
    text = 95,
    switchNode = 96,
    clipRegion = 98,
    extension = 100,
    lightSource = 101,
    lightPoint = 111,
    materialPalette = 113,
    nameTable = 114,
    continuouslyAdaptiveTerrain = 115,
    pushAttribute = 122,
    popAttribute = 123,
    curve = 126,
    roadConstruction = 127,
    indexedLightPoint = 130,
    lightPointSystem = 131
};
} // namespace flight

/// One record of a file, with its continuation records already appended.
struct FlightRecord {
    std::size_t offset = 0; ///< of its first byte in the file
    std::uint16_t opcode = 0;
    std::size_t fileLength =
        0;                  ///< bytes in the file, continuation records with their headers included
    std::string_view bytes; ///< header of 4 bytes and all payload

    std::size_t size() const { return bytes.size(); }
    /// Big-endian fields. `at` counts from the record's first byte; LogicError beyond the end.
    std::uint8_t u8(std::size_t at) const;
    std::int16_t i16(std::size_t at) const;
    std::uint16_t u16(std::size_t at) const;
    std::int32_t i32(std::size_t at) const;
    std::uint32_t u32(std::size_t at) const;
    float f32(std::size_t at) const;
    double f64(std::size_t at) const;
    /// Up to the first NUL, at most `length` bytes, cut at the record's end.
    std::string text(std::size_t at, std::size_t length) const;
};

/// The records of one file in their order. The bytes must outlive the object.
class FlightRecords {
  public:
    /// Walks to the pop that closes the first level or to zero padding. Appends to `diagnostics`
    /// what ends the walk early: a record that is shorter than its header or longer than the file.
    FlightRecords(std::string_view bytes, const std::string& file,
                  std::vector<Diagnostic>& diagnostics);

    const std::vector<FlightRecord>& all() const { return records_; }
    /// First byte behind the last record.
    std::size_t end() const { return end_; }

  private:
    std::vector<FlightRecord> records_;
    std::deque<std::string> joined_; ///< payloads of continued records
    std::size_t end_ = 0;
};

/// Bytes of one vertex of a local pool with these attributes: position, colour, normal, 8 layers.
std::size_t flightPoolStride(std::uint32_t mask);

/// "face", "vertex list": what messages call a record.
std::string flightRecordName(std::uint16_t opcode);

} // namespace irsg
