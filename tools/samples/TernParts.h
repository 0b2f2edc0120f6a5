#pragma once

#include "tools/samples/FlightWriter.h"
#include "tools/samples/TernSurfaces.h"

namespace smat::tern {

/// Where the nose is along y, m; stations count from there to the tail.
inline constexpr double nose_m = 8.5;
/// The engines' axes from the middle and above it, where they end and the nozzles begin.
inline constexpr double engine_m = 0.74, axis_m = 0.0;
inline constexpr double nozzleAt_m = 14.2, nozzleRoot_m = 0.45;

/// A nozzle with the plume behind it, and the indices of what it makes hot.
struct Nozzle {
    double length_m, exit_m, throat_m; ///< behind the nacelle; radii
    std::int32_t firstHot, firstGas;   ///< temperature indices, see samples/tern/README.md
};
/// At full power without and with reheat.
inline constexpr Nozzle dry{1.0, 0.31, 0.275, 20, 60}, reheat{0.92, 0.41, 0.375, 80, 120};

/// Body with canopy, intakes and their ducts, and the bays of the engines up to the nozzles.
void addBody(FlightWriter& writer, const HotParts& hot);
/// Wing with strakes, two fins and tailplanes.
void addWings(FlightWriter& writer);
/// Nozzle with its inside up to the turbine, at +-engine_m.
void addNozzle(FlightWriter& writer, const Nozzle& nozzle, const HotParts& hot, double side);
/// The gas of both engines: zones of the built-in jet, and what is in the nozzles.
void addPlumes(FlightWriter& writer, const Nozzle& nozzle, bool isReheat);

} // namespace smat::tern
