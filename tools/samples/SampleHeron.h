#pragma once

#include "irsg/gas/RoundJet.h"
#include "tools/samples/FlightWriter.h"

namespace smat {

/// A maritime patrol aircraft with two turboprops, 24 m long and 27 m of span: fuselage with panes
/// and windows, wing and tail with gaps before their control surfaces, engines with intakes,
/// nozzles with an inside, and their gas in zones. Codes as in samples/heron/README.md. Nose +y,
/// starboard +x; some 38,000 triangles with true normals.
FlightWriter heronModel();

/// The exhaust of one of its engines.
irsg::RoundJet heronJet();
/// So many zones stand for it, as `smat-batch plume --jet` finds for a bound of 0.04.
inline constexpr std::size_t heronZones = 7;

} // namespace smat
