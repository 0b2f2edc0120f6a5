#include "irsg/geometry/model/TailSearch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/conversion/SurfaceMesh.h"

namespace irsg {

namespace {

/// Parts of the length, from an end, and of the height, from below.
constexpr double endPart = 0.2, finPart = 0.25, finHeight = 0.6;
/// How much the area of a fin, of all area, and the width of an end count beside the height.
constexpr double finWeight = 8.0, widthWeight = 0.3;

/// What lies at one end.
struct End {
    double area = 0.0, heightArea = 0.0, finArea = 0.0;
    double least = HUGE_VAL, most = -HUGE_VAL; ///< across

    double height() const { return area > 0.0 ? heightArea / area : 0.0; }
    double width() const { return most > least ? most - least : 0.0; }
};

} // namespace

double tailTowards(const SurfaceMesh& mesh, const BoundingBox& box, int length, int up,
                   bool isDown) {
    const std::array<double, 3> low = {box.min.x, box.min.y, box.min.z},
                                high = {box.max.x, box.max.y, box.max.z};
    const auto at = [](int axis) { return static_cast<std::size_t>(axis); };
    const int across = 3 - length - up;
    const auto extent = [&](int axis) { return high[at(axis)] - low[at(axis)]; };
    if (!(extent(length) > 0.0 && extent(up) > 0.0 && extent(across) > 0.0))
        return 0.0;
    // 0 at one side of the box, 1 at the other.
    const auto part = [&](const osg::Vec3d& place, int axis) {
        return (place[axis] - low[at(axis)]) / extent(axis);
    };
    std::array<End, 2> ends;
    double area = 0.0;
    for (const auto& [kind, triangles] : mesh.parts())
        for (std::size_t i = 0; i + 2 < triangles.triangles.size(); i += 3) {
            std::array<osg::Vec3d, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = osg::Vec3d(toOsg(triangles.vertices[triangles.triangles[i + k]]));
            const osg::Vec3d normal = (corners[1] - corners[0]) ^ (corners[2] - corners[0]);
            const double own = normal.length() / 2.0;
            area += own;
            const osg::Vec3d middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            const double along = part(middle, length);
            const double height = isDown ? 1.0 - part(middle, up) : part(middle, up);
            End& nearest = ends[along > 0.5 ? 1 : 0];
            const double fromEnd = along > 0.5 ? 1.0 - along : along;
            if (fromEnd < endPart) {
                nearest.area += own;
                nearest.heightArea += own * height;
            }
            if (fromEnd < finPart && height > finHeight)
                nearest.finArea += std::abs(normal[across]) / 2.0;
            for (const osg::Vec3d& corner : corners) {
                const double there = part(corner, length);
                if (std::min(there, 1.0 - there) >= endPart)
                    continue;
                End& end = ends[there > 0.5 ? 1 : 0];
                end.least = std::min(end.least, part(corner, across));
                end.most = std::max(end.most, part(corner, across));
            }
        }
    if (!(area > 0.0) || ends[0].area == 0.0 || ends[1].area == 0.0)
        return 0.0;
    return ends[1].height() - ends[0].height() +
           finWeight * (ends[1].finArea - ends[0].finArea) / area +
           widthWeight * (ends[1].width() - ends[0].width());
}

} // namespace irsg
