#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "irsg/geometry/flight/FlightLog.h"

namespace irsg {

/// The vertex palette of an OpenFlight file: as long as it says, its vertices known by their place.
class FlightVertexPalette {
  public:
    explicit FlightVertexPalette(FlightLog& log) : log_(log) {}

    static bool isVertex(std::uint16_t opcode);
    void begin(const FlightRecord& record);
    void vertex(const FlightRecord& record);
    /// At the first record behind its vertices, or at the end of the file.
    void endAt(std::size_t offset);

    bool isThere() const { return isThere_; }
    std::size_t size() const { return end_ - start_; }
    /// Whether the vertex at this place in the palette has a normal; none where no vertex is there.
    std::optional<bool> hasNormal(std::uint32_t place) const;

  private:
    FlightLog& log_;
    bool isThere_ = false;
    bool isOpen_ = false;
    std::size_t start_ = 0, end_ = 0;
    std::unordered_map<std::uint32_t, bool> vertices_; ///< place, has a normal
};

} // namespace irsg
