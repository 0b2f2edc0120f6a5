#pragma once

#include "tools/samples/FlightWriter.h"

namespace smat {

/// Sphere of radius 1 m about the origin, codes 1 and 1, poles on z: one mesh of `rings` zones with
/// `segments` facets each, a fan at each pole and strips between. The vertices lie on the sphere
/// and have its normals.
FlightWriter sphereModel(int rings, int segments);

/// Box of 2 m (x) by 4 m (y) by 1 m (z) about the origin, material 1, temperature index by side:
/// 1 +y nose, 2 -y tail, 3 +x starboard, 4 -x port, 5 +z top, 6 -z bottom.
FlightWriter boxModel();

/// Plate of 1 m by 1 m about the origin in the xz plane, front towards +y, two-sided, codes 1
/// and 1.
FlightWriter plateModel();

} // namespace smat
