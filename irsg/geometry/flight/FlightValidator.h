#pragma once

#include "irsg/geometry/flight/FlightGeometry.h"

namespace irsg {

/// The walk of scanFlightBytes over the records of one file. Knows what the stock plug-in follows
/// without looking, and refuses what would lead it astray.
class FlightValidator {
  public:
    /// `file.bytes` must be set and stay where they are.
    FlightValidator(FlightFile& file, bool coloursGiven);
    /// Fills the file's faces, externals, remarks and steps; throws InputError with every
    /// diagnostic.
    void run();

  private:
    void visit(const FlightRecord& record);
    /// Each is false for a record of another kind.
    bool visitControl(const FlightRecord& record);
    bool visitPalette(const FlightRecord& record);
    bool visitAncillary(const FlightRecord& record);
    bool visitNode(const FlightRecord& record);

    void header(const FlightRecord& record);
    void switchNode(const FlightRecord& record);
    void external(const FlightRecord& record);
    void matrix(const FlightRecord& record);
    void replicate(const FlightRecord& record);

    FlightLog log_;
    FlightLevels levels_;
    FlightVertexPalette palette_;
    FlightGeometry geometry_;
    int extensionDepth_ = 0;
};

} // namespace irsg
