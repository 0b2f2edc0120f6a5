#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "irsg/geometry/reading/ModelCodes.h"

namespace irsg {

struct LoadedGraph;

/// The faces of a model one by one, to be chosen and painted: those that are drawn, in the axes and
/// the unit of its file, with who is beside whom. Corners within 1e-6 of the diagonal are one, so
/// that neither seams of normals nor drawables cut what is connected.
class FaceMesh {
  public:
    struct Face {
        unsigned int first = 0, count = 0; ///< of its triangles
        IrCodes codes;                     ///< of the file and of the rules beside it
        unsigned int material = 0;         ///< equal for faces of one material
        unsigned int part = 0;             ///< equal for faces that hang together by corners
        bool culled = false;               ///< is not drawn from behind
        bool turned = false;               ///< its painted triangles run the other way round
        Vec3 point, normal;                ///< inside of it; unit, towards its front
        double area = 0.0;                 ///< in squares of the file's unit
    };
    using Triangle = std::array<Vec3, 3>; ///< counter-clockwise from the front
    /// Another face along a common edge.
    struct Neighbour {
        unsigned int face = 0;
        bool opposed = false; ///< its front is where this one has its back
    };

    /// Of a graph as its file has it (loadGraphAsIs). Throws InputError as forEachPolygon does.
    FaceMesh(const LoadedGraph& graph, const std::vector<CodeRule>& rules, const std::string& name);

    const std::vector<Face>& faces() const { return faces_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    std::span<const Triangle> trianglesOf(const Face& face) const {
        return std::span(triangles_).subspan(face.first, face.count);
    }
    std::span<const Neighbour> neighboursOf(std::size_t face) const {
        return std::span(neighbours_).subspan(beginOf_[face], beginOf_[face + 1] - beginOf_[face]);
    }
    /// What the faces have when these surfaces are painted over file and rules.
    std::vector<IrCodes> codes(const std::vector<PaintedSurface>& painted) const;
    double diagonal() const { return diagonal_; }

  private:
    void join();

    std::vector<Face> faces_;
    std::vector<Triangle> triangles_;
    std::vector<unsigned int> beginOf_; ///< into neighbours_, by face; one more than faces
    std::vector<Neighbour> neighbours_;
    double diagonal_ = 0.0;
};

} // namespace irsg
