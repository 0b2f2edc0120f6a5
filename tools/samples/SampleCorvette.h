#pragma once

#include "tools/samples/FlightWriter.h"

namespace smat {

/// A corvette of 72 m: flared hull, deck, superstructure with sloped sides and a band of windows,
/// mast, gun, two funnels that are open and have an inside, a plume over each. Codes as in
/// samples/corvette/README.md. Bow +y, starboard +x, the water at z = 0; about 8,000 triangles.
FlightWriter corvetteModel();

} // namespace smat
