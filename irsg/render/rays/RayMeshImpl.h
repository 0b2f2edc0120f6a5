#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "irsg/render/rays/RayMesh.h"

namespace irsg {

/// Corners in the axes of the mesh, three numbers each. Embree reads four.
struct Corners {
    std::vector<float> vertices, normals;

    Vec3 vertex(unsigned i) const { return at(vertices, i); }
    Vec3 normal(unsigned i) const { return at(normals, i); }

  private:
    static Vec3 at(const std::vector<float>& numbers, unsigned i) {
        const float* v = &numbers[3 * static_cast<std::size_t>(i)];
        return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    }
};

struct TracedPiece {
    const Corners* corners = nullptr;
    std::vector<unsigned> triangles;
};

/// A facet that the search in float has come by.
struct Candidate {
    unsigned piece, facet;
};

/// What a mesh is made of.
struct RayMesh::Impl {
    std::map<std::pair<const osg::Array*, osg::Matrixd>, Corners> corners;
    std::vector<TracedPiece> pieces;
    RTCScene scene = nullptr;
    osg::Vec3d low{1, 1, 1}, high{-1, -1, -1}; ///< of the box, widened by rounding
    double rounding_m = 0.0;                   ///< of places on the mesh in float
    std::size_t facets = 0;

    ~Impl();
    void add(const Piece& piece);
    void attach(std::size_t number);
    void commit();

    /// What of a ray lies in the box; false for nothing.
    bool clip(const Ray& ray, double& from_m, double& to_m) const;

    /// Where a ray meets a facet that the search has found, Moeller and Trumbore 1997.
    RayHit refined(const Ray& ray, const Candidate& candidate) const;

    /// A ray in float, from where it enters the box.
    RTCRay rayFrom(const Ray& ray, double from_m, double to_m) const;
};

} // namespace irsg
