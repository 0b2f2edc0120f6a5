#include "irsg/geometry/reading/Triangulation.h"

#include <algorithm>
#include <cmath>

namespace irsg {
namespace {

constexpr double thinnest = 1e-9;

struct Plane {
    std::vector<double> x, y;

    /// Twice the signed area of a triangle, positive where it turns left.
    double turn(std::size_t a, std::size_t b, std::size_t c) const {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
    bool inside(std::size_t p, std::size_t a, std::size_t b, std::size_t c) const {
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }
    bool same(std::size_t a, std::size_t b) const { return x[a] == x[b] && y[a] == y[b]; }
};

osg::Vec3d newellNormal(const std::vector<PolygonCorner>& corners) {
    // Relative to the first corner, so that a place far from the origin loses no digits.
    const auto origin = corners.front().position;
    osg::Vec3d sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (corners[i].position - origin) ^ (corners[i + 1].position - origin);
    return sum;
}

Plane project(const std::vector<PolygonCorner>& corners, const osg::Vec3d& normal) {
    const osg::Vec3d any = std::abs(normal.x()) < 0.6 ? osg::Vec3d(1, 0, 0) : osg::Vec3d(0, 1, 0);
    osg::Vec3d u = any ^ normal;
    u.normalize();
    const osg::Vec3d v = normal ^ u;
    Plane plane;
    for (const auto& corner : corners) {
        const auto p = corner.position - corners.front().position;
        plane.x.push_back(p * u);
        plane.y.push_back(p * v);
    }
    return plane;
}

/// Whether it turns left at every corner and, which a star does not, around the first one.
bool isConvex(const Plane& plane, double tolerance) {
    const std::size_t count = plane.x.size();
    for (std::size_t i = 0; i < count; ++i)
        if (plane.turn(i, (i + 1) % count, (i + 2) % count) < -tolerance)
            return false;
    for (std::size_t i = 1; i + 1 < count; ++i)
        if (plane.turn(0, i, i + 1) < -tolerance)
            return false;
    return true;
}

/// Looks at corners a polygon may take, for each of its own: more than any that is drawn by a
/// person needs, and a bound for one that is made to take for ever.
constexpr std::size_t mostLooks = 4096;

/// Cuts an ear off until three corners are left; false where no ear is to be found.
bool cutEars(const Plane& plane, std::vector<std::array<std::size_t, 3>>& triangles) {
    std::vector<std::size_t> left(plane.x.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        left[i] = i;
    std::size_t looks = mostLooks * left.size();
    while (left.size() > 3) {
        bool found = false;
        for (std::size_t i = 0; i < left.size() && !found; ++i) {
            const auto a = left[(i + left.size() - 1) % left.size()], b = left[i],
                       c = left[(i + 1) % left.size()];
            if (plane.turn(a, b, c) < 0)
                continue;
            if (looks < left.size())
                return false;
            looks -= left.size();
            const bool ear = std::none_of(left.begin(), left.end(), [&](std::size_t p) {
                return p != a && p != b && p != c && !plane.same(p, a) && !plane.same(p, b) &&
                       !plane.same(p, c) && plane.turn(a, b, c) > 0 && plane.inside(p, a, b, c);
            });
            if (!ear)
                continue;
            triangles.push_back({a, b, c});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            found = true;
        }
        if (!found)
            return false;
    }
    triangles.push_back({left[0], left[1], left[2]});
    return plane.turn(left[0], left[1], left[2]) >= 0;
}

} // namespace

Triangulation triangulate(const std::vector<PolygonCorner>& corners) {
    Triangulation cut;
    if (corners.size() < 3)
        return cut;

    // Extent against area tells a polygon from a line.
    double extent = 0.0;
    for (const auto& corner : corners)
        extent = std::max(extent, (corner.position - corners.front().position).length());
    cut.normal = newellNormal(corners);
    const double twiceArea = cut.normal.normalize();
    if (!(twiceArea > thinnest * extent * extent))
        return cut;

    // Convex about the first corner: a fan, as a triangle always is. Else ears.
    std::vector<std::array<std::size_t, 3>> triangles;
    const auto fan = [&] {
        triangles.clear();
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            triangles.push_back({0, i, i + 1});
    };
    fan();
    if (corners.size() > 3) {
        const auto plane = project(corners, cut.normal);
        if (!isConvex(plane, thinnest * extent * extent)) {
            triangles.clear();
            cut.convex = false;
            if (!cutEars(plane, triangles)) {
                cut.folded = true;
                fan();
            }
        }
    }

    for (const auto& triangle : triangles) {
        const auto &a = corners[triangle[0]].position, &b = corners[triangle[1]].position,
                   &c = corners[triangle[2]].position;
        const double twice = ((b - a) ^ (c - a)).length();
        const double side2 = std::max({(b - a).length2(), (c - b).length2(), (a - c).length2()});
        if (!(twice > thinnest * side2))
            continue;
        cut.triangles.push_back(triangle);
        cut.area += 0.5 * twice;
    }
    return cut;
}

} // namespace irsg
