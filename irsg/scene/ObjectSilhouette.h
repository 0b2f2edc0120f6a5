#pragma once

#include <functional>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/Pose.h"

namespace irsg {

/// A slice of what is seen of an object.
struct SilhouettePart {
    double above_rad = 0.0; ///< elevation less that of the reference point, in the flat scene
    double weight = 0.0;    ///< its part of the solid angle
};

/// Which elevations an object covers, and how much of it lies at each: the solid angles of its
/// facets, front and back alike, in slices of 1/32 of `reach_rad`, the angle of its sphere about
/// the reference point. What one part hides of another counts twice, so the slices of a convex
/// object are exact. `counts(part)` says which parts of the mesh do; empty where none is seen. The
/// sensor stands outside of the sphere.
std::vector<SilhouettePart> silhouetteOf(const Mesh& mesh, const Pose& pose, const Vec3& sensor_m,
                                         const Vec3& reference_m, double reach_rad,
                                         const std::function<bool(const Mesh::Part&)>& counts);

} // namespace irsg
