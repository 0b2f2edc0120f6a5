#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <embree3/rtcore.h>

#include "irsg/render/rays/RayMesh.h"

namespace irsg {

struct TracedPiece {
    const Mesh::Part* part = nullptr;
    std::span<const unsigned> triangles;

    Vec3 vertex(unsigned i) const { return toVec3(part->vertices[i]); }
    Vec3 normal(unsigned i) const { return toVec3(part->normals[i]); }
};

/// A facet that the search in float has come by.
struct Candidate {
    unsigned piece, facet;
};

struct RayMesh::Impl {
    std::shared_ptr<const Mesh> mesh;
    std::vector<TracedPiece> pieces;
    /// Of each part where Embree, which reads 4 bytes beyond the last, would leave its own: a copy
    /// with one more.
    std::vector<std::vector<Float3>> padded;
    RTCScene scene = nullptr;
    std::array<double, 3> low{1, 1, 1}, high{-1, -1, -1}; ///< of the box, widened by rounding
    double rounding_m = 0.0;                              ///< of places on the mesh in float
    std::size_t facets = 0;
    std::once_flag closeSheetsFound;
    std::vector<std::vector<std::uint8_t>> hasCloseSheet; ///< by piece and facet

    explicit Impl(std::shared_ptr<const Mesh> of);
    ~Impl();
    void attach(std::size_t number);
    void commit();

    /// How far apart facets are that are no close sheets, m.
    double closeSheets_m() const;
    void findCloseSheets();

    /// What of a ray lies in the box; false for nothing.
    bool clip(const Ray& ray, double& from_m, double& to_m) const;

    /// Where a ray meets a facet that the search has found, Moeller and Trumbore 1997.
    RayHit refined(const Ray& ray, const Candidate& candidate) const;

    /// A ray in float, from where it enters the box.
    RTCRay rayFrom(const Ray& ray, double from_m, double to_m) const;
};

} // namespace irsg
