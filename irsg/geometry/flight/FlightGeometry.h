#pragma once

#include "irsg/geometry/flight/FlightLevels.h"
#include "irsg/geometry/flight/FlightVertexPalette.h"

namespace irsg {

/// The faces and meshes of an OpenFlight file with their vertices.
class FlightGeometry {
  public:
    FlightGeometry(FlightLog& log, FlightLevels& levels, FlightVertexPalette& palette,
                   bool hasColours)
        : log_(log), levels_(levels), palette_(palette), hasColours_(hasColours) {}

    /// False for a record of another kind.
    bool visit(const FlightRecord& record);
    /// A palette of colours was read.
    void setColours() { hasColours_ = true; }
    bool hasColours() const { return hasColours_; }
    void finish();

  private:
    void face(const FlightRecord& record);
    void vertexList(const FlightRecord& record);
    void localVertexPool(const FlightRecord& record);
    void meshPrimitive(const FlightRecord& record);

    FlightLog& log_;
    FlightLevels& levels_;
    FlightVertexPalette& palette_;
    bool hasColours_;
    int billboards_ = 0;
};

} // namespace irsg
