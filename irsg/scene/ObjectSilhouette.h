#pragma once

#include <functional>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/Pose.h"

namespace irsg {

/// A slice of what is seen of an object.
struct SilhouettePart {
    double above_rad = 0.0; ///< elevation less that of the reference point, in the flat scene
    double weight = 0.0;    ///< its part of what is hidden of the background
};

/// Which elevations an object covers, and how much of the background it hides at each: the solid
/// angles of its facets, front and back alike, times their opacities, in slices of 1/32 of
/// `reach_rad`, the angle of its sphere about the reference point. Where facets lie behind each
/// other a grid of 256 by 256 points tells what they hide together, so that the slices of a convex
/// opaque object and of a plate are exact. At cosines of the elevation below 0.1 all facets count.
/// `opacityOf(part)`: 0 to 1, of the facets of a part of the mesh; empty where none hides anything.
/// The sensor stands outside of the sphere.
std::vector<SilhouettePart> silhouetteOf(const Mesh& mesh, const Pose& pose, const Vec3& sensor_m,
                                         const Vec3& reference_m, double reach_rad,
                                         const std::function<double(const Mesh::Part&)>& opacityOf);

} // namespace irsg
