#pragma once

#include <map>
#include <vector>

#include <osg/Geometry>

#include "irsg/geometry/reading/DrawablePolygons.h"
#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// Triangles merged per layer, pair of codes and culling: what a Model draws. Vertices with equal
/// position, normal and colour are shared; the order is that of the polygons, so equal input gives
/// equal arrays.
class SurfaceMesh {
  public:
    struct Key {
        int layer = 0; ///< depth of a subface: it is drawn over the face it lies on
        IrCodes codes;
        bool culled = false; ///< back faces are not drawn
        auto operator<=>(const Key&) const = default;
    };
    struct Part {
        std::vector<osg::Vec3> vertices, normals;
        std::vector<osg::Vec4> colours;
        std::vector<unsigned int> triangles;
        std::vector<unsigned int> polygonOf; ///< of each triangle, its number in the file's order
        long polygons = 0;
        double area_m2 = 0.0;
        BoundingBox bounds = BoundingBox::nowhere();
    };

    /// Adds a polygon in model axes, counter-clockwise from its front. A concave one is cut into
    /// ears. Normals that are missing, zero or not finite become the polygon's own; normals that
    /// point away from the front are turned. A polygon without area is counted and left out.
    void add(const Key& key, std::vector<PolygonCorner>& corners);

    const std::map<Key, Part>& parts() const { return parts_; }
    /// How many polygons have a number, which is how many were added.
    unsigned int polygons() const { return polygons_; }
    /// Gives polygons another layer, by their numbers; -1 leaves one where it is.
    void setLayers(const std::vector<int>& layers);
    long degenerate() const { return degenerate_; }
    long normalsMade() const { return normalsMade_; }
    long normalsTurned() const { return normalsTurned_; }
    long folded() const { return folded_; } ///< polygons that cross themselves, drawn as a fan

    /// A drawable of indexed triangles with vertices, unit normals, colours, its codes and a
    /// StateSet with nothing but the culling of back faces and, for a layer, a PolygonOffset.
    static osg::ref_ptr<osg::Geometry> drawable(const Key& key, const Part& part);

  private:
    /// The vertices of a part by what they are: their numbers in slots that a hash chooses, or the
    /// next that is free. Besides the part's own arrays it takes 8 to 16 bytes a vertex.
    class VertexTable {
      public:
        /// The number of the vertex in the part, to whose arrays a new one is appended.
        unsigned int index(Part& part, const PolygonCorner& corner);

      private:
        void grow(const Part& part);
        std::vector<unsigned int> slots_; ///< number + 1, 0 where free; a power of two of them
    };
    std::map<Key, Part> parts_;
    std::map<Key, VertexTable> tables_;
    unsigned int polygons_ = 0;
    long degenerate_ = 0, normalsMade_ = 0, normalsTurned_ = 0, folded_ = 0;
};

} // namespace irsg
