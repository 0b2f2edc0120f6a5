#pragma once

#include "tools/samples/FlightWriter.h"

namespace smat {

/// A maritime patrol aircraft with two turboprops, 24 m long and 27 m of span: fuselage with panes
/// and windows, wing and tail with gaps before their control surfaces, engines with intakes,
/// nozzles with an inside and plumes of three shells. Codes as in samples/heron/README.md. Nose +y,
/// starboard +x; some 38,000 triangles with true normals.
FlightWriter heronModel();

} // namespace smat
