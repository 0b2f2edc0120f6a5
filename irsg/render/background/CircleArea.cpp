#include "irsg/render/background/CircleArea.h"

#include <algorithm>
#include <cmath>

namespace irsg {

namespace {

double cross(const PlanePoint& a, const PlanePoint& b) {
    return a.x * b.y - a.y * b.x;
}
double dot(const PlanePoint& a, const PlanePoint& b) {
    return a.x * b.x + a.y * b.y;
}
double sector(const PlanePoint& a, const PlanePoint& b) {
    return 0.5 * std::atan2(cross(a, b), dot(a, b));
}

/// Signed area between the centre and an edge, as far as it is in the circle.
double edgeArea(const PlanePoint& a, const PlanePoint& b) {
    const PlanePoint way{b.x - a.x, b.y - a.y};
    const double square = dot(way, way), along = dot(a, way);
    const double discriminant = along * along - square * (dot(a, a) - 1.0);
    if (square == 0.0 || discriminant <= 0.0)
        return sector(a, b);
    const double root = std::sqrt(discriminant);
    const double enters = std::max((-along - root) / square, 0.0);
    const double leaves = std::min((-along + root) / square, 1.0);
    if (enters >= leaves)
        return sector(a, b);
    const auto at = [&](double t) { return PlanePoint{a.x + t * way.x, a.y + t * way.y}; };
    const PlanePoint in = at(enters), out = at(leaves);
    double area = 0.5 * cross(in, out);
    if (enters > 0.0)
        area += sector(a, in);
    if (leaves < 1.0)
        area += sector(out, b);
    return area;
}

} // namespace

double areaInUnitCircle(std::span<const PlanePoint> polygon) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += edgeArea(polygon[i], polygon[(i + 1) % polygon.size()]);
    return area;
}

} // namespace irsg
