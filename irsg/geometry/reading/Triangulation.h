#pragma once

#include <array>
#include <vector>

#include "irsg/geometry/reading/DrawablePolygons.h"

namespace irsg {

/// A polygon cut into triangles of its corners.
struct Triangulation {
    std::vector<std::array<std::size_t, 3>> triangles; ///< none for a polygon without area
    osg::Vec3d normal;                                 ///< unit, Newell's
    double area = 0.0;                                 ///< of the triangles
    bool convex = true;  ///< a fan about any of its corners is the same surface
    bool folded = false; ///< crosses itself, or has too many corners: a fan was all it gave
};

/// Cuts a polygon, counter-clockwise about its normal: a convex one into a fan as OpenGL does, a
/// concave one by cutting off ears in the plane of its normal. Newell's normal is the sum of the
/// cross products of its edges and holds for corners that are not quite in one plane. Triangles
/// thinner than 1e-9 of their longest side are left out.
Triangulation triangulate(const std::vector<PolygonCorner>& corners);

} // namespace irsg
