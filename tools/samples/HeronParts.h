#pragma once

#include "tools/samples/FlightWriter.h"

namespace smat::heron {

/// Where the nose is along y, m; stations count from there to the tail.
inline constexpr double nose_m = 11.5;
/// The engines' axes from the middle, and the height of the wing at its root, m.
inline constexpr double engine_m = 4.15;
inline constexpr double wingHeight_m = 1.62;

/// Body with panes, windows, radomes, wheel housings and what else stands out of it.
void addFuselage(FlightWriter& writer);
/// Wing, fin and tailplane, each with a gap before its control surfaces.
void addWings(FlightWriter& writer);
/// Nacelle, intake, propeller, nozzle and plume at +-engine_m.
void addEngine(FlightWriter& writer, double side);

} // namespace smat::heron
