#pragma once

#include "irsg/gas/BentJet.h"
#include "tools/samples/FlightWriter.h"

namespace smat {

/// A corvette of 72 m: flared hull, deck, superstructure with sloped sides and a band of windows,
/// mast, gun, two funnels that are open and have an inside, the gas over each in zones. Codes as in
/// samples/corvette/README.md. Bow +y, starboard +x, the water at z = 0; about 8,000 triangles.
FlightWriter corvetteModel();

/// The exhaust of one of its funnels, starboard where `side` is 1, on the port side where -1.
irsg::BentJet corvetteJet(double side);
/// So many zones stand for it, as `smat-batch plume` finds for a bound of 0.15.
inline constexpr std::size_t corvetteZones = 9;

} // namespace smat
