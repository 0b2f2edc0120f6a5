#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/Vec2d>
#include <osg/Vec3d>
#include <osg/Vec4>

namespace osg {
class Geometry;
}

namespace irsg {

/// A vertex of a polygon, in the axes of its drawable.
struct PolygonCorner {
    osg::Vec3d position;
    osg::Vec3d normal; ///< (0, 0, 0) where the file has none
    osg::Vec4 colour{1, 1, 1, 1};
    osg::Vec2d onTexture;    ///< of the first texture; (0, 0) where the drawable has no such places
    unsigned int vertex = 0; ///< its place in the drawable's arrays
};

/// Calls `each` with the corners of every triangle, quad and polygon of a drawable,
/// counter-clockwise from the front as OpenGL assembles them; strips and fans come as their
/// triangles and quads. Returns how many lines, points and patches were passed over. Throws
/// InputError, naming `name`, for an index beyond the vertices, a coordinate that is not finite and
/// a drawable with vertices of a type that is no position.
long forEachPolygon(const osg::Geometry& geometry, const std::string& name,
                    const std::function<void(std::vector<PolygonCorner>&)>& each);

} // namespace irsg
