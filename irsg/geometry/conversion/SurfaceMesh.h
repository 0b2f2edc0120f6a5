#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/reading/DrawablePolygons.h"

namespace irsg {

/// Makes the parts of a Mesh from polygons. Vertices of a part with equal position, normal and
/// colour are shared; the order is that of the polygons, so equal input gives equal arrays.
class SurfaceMesh {
  public:
    struct Part : Mesh::Part {
        std::vector<unsigned int> polygonOf; ///< of each triangle, its number in the file's order
        std::vector<unsigned int> colourOf;  ///< of each vertex, its number among all colours
    };

    /// Adds a polygon in model axes, counter-clockwise from its front. A concave one is cut into
    /// ears. Normals that are missing, zero or not finite become the polygon's own; normals that
    /// point away from the front are turned. A polygon without area is counted and left out.
    void add(const Mesh::Kind& kind, std::vector<PolygonCorner>& corners);

    const std::map<Mesh::Kind, Part>& parts() const { return parts_; }
    /// The parts, which are no longer here then.
    std::vector<Mesh::Part> take();
    /// How many polygons have a number, which is how many were added.
    unsigned int polygons() const { return polygons_; }
    /// Gives polygons another layer, by their numbers; -1 leaves one where it is.
    void setLayers(const std::vector<int>& layers);
    long degenerate() const { return degenerate_; }
    long normalsMade() const { return normalsMade_; }
    long normalsTurned() const { return normalsTurned_; }
    long folded() const { return folded_; } ///< polygons that cross themselves, drawn as a fan

  private:
    /// The vertices of a part by what they are: their numbers in slots that the first bits of a
    /// hash choose, or the next that is free. Besides the part's own arrays it takes 16 to 32 bytes
    /// a vertex, which are those of a look at one place in memory.
    class VertexTable {
      public:
        struct Vertex {
            Vertex(const PolygonCorner& corner, unsigned int ofColour);
            Float3 place, normal;
            unsigned int colour;
            std::uint32_t hash;
        };
        /// Fetches the place in memory that index() looks at, while others are looked at.
        void prepare(const Vertex& vertex) const;
        /// The number of the vertex in the part, to whose arrays a new one is appended.
        unsigned int index(Part& part, const Vertex& vertex);

      private:
        struct Slot {
            unsigned int number = 0; ///< and 1; 0 where free
            std::uint32_t hash = 0;
        };
        void grow();
        std::size_t freeFor(std::uint32_t hash) const;
        std::vector<Slot> slots_; ///< a power of two of them
        int shift_ = 0;           ///< of a hash, to its slot
    };
    /// Numbers of colours, of all bits: they may be no numbers.
    class ColourNumbers {
      public:
        unsigned int of(const osg::Vec4& colour);

      private:
        using Bits = std::array<std::uint32_t, 4>;
        std::map<Bits, unsigned int> numbers_;
        Bits last_{};
        unsigned int lastNumber_ = 0;
    };
    ColourNumbers colours_;
    std::map<Mesh::Kind, Part> parts_;
    std::map<Mesh::Kind, VertexTable> tables_;
    std::vector<VertexTable::Vertex> ofPolygon_; ///< of the one that is added
    unsigned int polygons_ = 0;
    long degenerate_ = 0, normalsMade_ = 0, normalsTurned_ = 0, folded_ = 0;
};

} // namespace irsg
