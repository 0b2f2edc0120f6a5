#pragma once

#include <vector>

#include "irsg/geometry/reading/Triangulation.h"

namespace irsg {

/// Where a polygon is, for all that is asked of it by place.
struct PolygonPlace {
    osg::Vec3d point;  ///< inside of it: the middle of its largest triangle
    osg::Vec3d normal; ///< unit
    double area = 0.0;
    Triangulation cut;
};

inline PolygonPlace placeOf(const std::vector<PolygonCorner>& corners) {
    PolygonPlace place;
    place.cut = triangulate(corners);
    place.normal = place.cut.normal;
    place.area = place.cut.area;
    double largest = -1.0;
    for (const auto& triangle : place.cut.triangles) {
        const osg::Vec3d &a = corners[triangle[0]].position, &b = corners[triangle[1]].position,
                         &c = corners[triangle[2]].position;
        const double area = ((b - a) ^ (c - a)).length();
        if (area > largest) {
            largest = area;
            place.point = (a + b + c) / 3.0;
        }
    }
    return place;
}

} // namespace irsg
