#pragma once

#include <span>

namespace irsg {

/// A point of a plane.
struct PlanePoint {
    double x = 0.0, y = 0.0;
};

/// Area that a polygon, counter-clockwise, has in common with the unit circle about the origin:
/// exact, the sum over the edges of the triangles and sectors between them and the centre.
double areaInUnitCircle(std::span<const PlanePoint> polygon);

} // namespace irsg
