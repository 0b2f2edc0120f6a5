#include "irsg/render/rays/LightMesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// A triangle of the lattice of a facet: its column and row, and whether it points the other way.
struct LatticeTriangle {
    std::uint32_t i = 0, j = 0;
    bool isTurned = false;

    std::array<std::pair<std::uint32_t, std::uint32_t>, 3> corners() const {
        if (isTurned)
            return {{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}};
        return {{{i, j}, {i + 1, j}, {i, j + 1}}};
    }
    /// Those of a column follow one another, from the facet's first corner on.
    std::uint32_t number(std::uint32_t parts) const {
        return i * (2 * parts - i) + 2 * j + (isTurned ? 1 : 0);
    }
    static LatticeTriangle of(std::uint32_t number, std::uint32_t parts) {
        LatticeTriangle found;
        while (number >= 2 * (parts - found.i) - 1) {
            number -= 2 * (parts - found.i) - 1;
            ++found.i;
        }
        found.j = number / 2;
        found.isTurned = number % 2 == 1;
        return found;
    }
};

Vec3 between(const std::array<Vec3, 3>& corners_m, std::uint32_t i, std::uint32_t j,
             std::uint32_t parts) {
    const double u = static_cast<double>(i) / parts, v = static_cast<double>(j) / parts;
    return corners_m[0] * (1.0 - u - v) + corners_m[1] * u + corners_m[2] * v;
}

/// Of models with more facets, some are probed for all.
constexpr std::size_t mostFacetsProbed = 100'000;
/// Of a facet; of one that is a large part of the surface, where what stands before it fills little
/// of its hemisphere.
constexpr std::uint32_t fewRays = 16, someRays = 32, manyRays = 256;
constexpr double nearest = 0.1;           ///< that counts, of the longest edge
constexpr std::uint32_t fineParts = 1024; // of an edge, of which all others are multiples

} // namespace

/// Numbers vertices so that triangles share those at places they share.
class LightMesh::Numbering {
  public:
    explicit Numbering(std::vector<Vertex>& vertices) : vertices_(vertices) {}

    std::uint32_t at(std::uint32_t piece, std::size_t number, const RayMesh::Facet& facet,
                     std::uint32_t i, std::uint32_t j, std::uint32_t parts) {
        const std::uint32_t k = parts - i - j;
        if (k == parts)
            return corner(piece, facet, 0);
        if (i == parts)
            return corner(piece, facet, 1);
        if (j == parts)
            return corner(piece, facet, 2);
        const std::uint32_t step = fineParts / parts;
        if (j == 0)
            return onEdge(piece, facet, 0, 1, i * step);
        if (i == 0)
            return onEdge(piece, facet, 0, 2, j * step);
        if (k == 0)
            return onEdge(piece, facet, 1, 2, j * step);
        const auto [known, isNew] = inside_.try_emplace({number, i, j}, 0);
        return isNew ? known->second = add(piece) : known->second;
    }

  private:
    std::uint32_t add(std::uint32_t piece) {
        vertices_.push_back({piece, {}, {}, 0.0});
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }
    std::uint32_t corner(std::uint32_t piece, const RayMesh::Facet& facet, std::size_t which) {
        std::vector<std::uint32_t>& numbers = corners_[{piece, facet.arrays}];
        const unsigned vertex = facet.vertices[which];
        if (vertex >= numbers.size())
            numbers.resize(std::max<std::size_t>(vertex + 1, 2 * numbers.size()), none);
        if (numbers[vertex] == none)
            numbers[vertex] = add(piece);
        return numbers[vertex];
    }
    std::uint32_t onEdge(std::uint32_t piece, const RayMesh::Facet& facet, std::size_t from,
                         std::size_t to, std::uint32_t part) {
        unsigned a = facet.vertices[from], b = facet.vertices[to];
        if (a > b) {
            std::swap(a, b);
            part = fineParts - part;
        }
        const auto [known, isNew] = edges_.try_emplace({piece, facet.arrays, a, b, part}, 0);
        return isNew ? known->second = add(piece) : known->second;
    }

    std::vector<Vertex>& vertices_;
    std::map<std::pair<std::uint32_t, const void*>, std::vector<std::uint32_t>> corners_;
    std::map<std::tuple<std::uint32_t, const void*, unsigned, unsigned, std::uint32_t>,
             std::uint32_t>
        edges_;
    std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, std::uint32_t> inside_;
};

LightMesh::LightMesh(std::shared_ptr<const RayMesh> mesh, const PieceUses& uses,
                     const LightResolution& resolution)
    : mesh_(std::move(mesh)) {
    BoundingBox all = BoundingBox::nowhere();
    for (std::size_t piece = 0; piece < mesh_->pieces(); ++piece) {
        firstFacet_.push_back(static_cast<std::uint32_t>(facets_.size()));
        BoundingBox box = BoundingBox::nowhere();
        for (unsigned f = 0; f < mesh_->facetsOf(piece); ++f) {
            const auto& c = mesh_->facet(piece, f).corners_m;
            const Vec3 across = cross(c[1] - c[0], c[2] - c[0]);
            area_m2_ += 0.5 * length(across);
            facets_.push_back({0, 1, {}, across == Vec3{} ? Vec3{0, 0, 1} : normalized(across)});
            pieceOfFacet_.push_back(static_cast<std::uint32_t>(piece));
            for (const Vec3& v : c)
                box.include(v);
        }
        all.include(box);
        if (uses[piece].isThere && !uses[piece].transparent && box.valid())
            opaque_.push_back(box);
    }
    extent_m_ = all.valid() ? all.diagonal_m() : 0.0;

    std::vector<Probe> probes(facets_.size());
    const std::size_t stride = facets_.size() / mostFacetsProbed + 1;
    parallelFor((facets_.size() + stride - 1) / stride,
                [&](std::size_t i) { probe(i * stride, uses, probes[i * stride]); });
    for (std::size_t i = 0; stride > 1 && i < facets_.size(); ++i) {
        const std::size_t known = i - i % stride;
        if (known != i && pieceOfFacet_[known] == pieceOfFacet_[i]) {
            probes[i] = probes[known];
            facets_[i].sees = facets_[known].sees;
        }
    }
    chooseParts(probes, resolution);
    Numbering numbering(vertices_);
    for (std::size_t i = 0; i < facets_.size(); ++i)
        addTriangles(i, probes[i], numbering);
    for (Vertex& vertex : vertices_)
        vertex.normal =
            vertex.normal == Vec3{} ? Vec3{0, 0, 1} : vertex.normal * (1.0 / length(vertex.normal));
}

void LightMesh::probe(std::size_t number, const PieceUses& uses, Probe& probe) {
    const std::size_t piece = pieceOfFacet_[number];
    const auto& c = mesh_->facet(piece, numberInPiece(number)).corners_m;
    Facet& own = facets_[number];
    for (std::size_t i = 0; i < 3; ++i)
        probe.longest_m = std::max(probe.longest_m, length(c[(i + 1) % 3] - c[i]));
    const double area_m2 = 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
    const PieceUse& use = uses[piece];
    if (!use.isThere)
        return;
    const int sides = use.cullsBackFaces && !use.transparent ? 1 : 2;
    RayHit hit;
    std::vector<RayHit> through;
    std::vector<Vec3> seen_m;
    const LightPoints points(static_cast<std::uint32_t>(number + 1) * 0x9e3779b9u);
    for (int side = 0; side < sides; ++side) {
        const Vec3 up = side == 0 ? own.normal : own.normal * -1.0;
        const bool isAllBehind = std::ranges::all_of(opaque_, [&](const BoundingBox& box) {
            const Vec3 half = (box.max - box.min) * 0.5;
            const double reach_m =
                std::abs(up.x) * half.x + std::abs(up.y) * half.y + std::abs(up.z) * half.z;
            return dot(box.centre() - c[0], up) + reach_m <= 1e-5 * extent_m_;
        });
        if (isAllBehind)
            continue;
        seen_m.clear();
        double sum_per_m2 = 0.0;
        const std::uint32_t rays = area_m2 > 0.01 * area_m2_ ? manyRays
                                   : facets_.size() < 10'000 ? someRays
                                                             : fewRays;
        for (std::uint32_t i = 0; i < rays; ++i) {
            const LightPoint point = points.at(i);
            // A facet has no parts to choose from: its place takes the first two coordinates.
            const double root = std::sqrt(point[0]);
            const double u = root * (1.0 - point[1]), v = root * point[1];
            const Vec3 at = c[0] * (1.0 - u - v) + c[1] * u + c[2] * v;
            const Ray ray{at + up * (1e-6 * extent_m_), cosineDirection(up, point[2], point[3])};
            if (!mesh_->meet(ray, uses, 0.0, hit, through))
                continue;
            sum_per_m2 += std::pow(std::max(hit.distance_m, nearest * probe.longest_m), -2.0);
            seen_m.push_back(ray.origin_m + ray.direction * hit.distance_m);
        }
        own.sees[static_cast<std::size_t>(side)] = !seen_m.empty();
        const double nearness_per_m = std::sqrt(sum_per_m2 / rays);
        if (nearness_per_m > probe.nearness_per_m) {
            probe.nearness_per_m = nearness_per_m;
            probe.rays = rays;
            std::swap(probe.seen_m, seen_m);
        }
    }
}

void LightMesh::chooseParts(const std::vector<Probe>& probes, const LightResolution& resolution) {
    for (double edge = resolution.edgePerDistance;; edge *= 1.5) {
        std::size_t triangles = 0;
        bool isAnyCut = false;
        for (std::size_t i = 0; i < facets_.size(); ++i) {
            double parts = probes[i].longest_m * probes[i].nearness_per_m / edge;
            if (resolution.longestEdge_m > 0.0)
                parts = std::max(parts, probes[i].longest_m / resolution.longestEdge_m *
                                            resolution.edgePerDistance / edge);
            const auto wanted = static_cast<unsigned>(
                std::ceil(std::clamp(parts, 1.0, static_cast<double>(resolution.mostParts))));
            facets_[i].parts = static_cast<std::uint16_t>(std::bit_ceil(wanted));
            triangles += static_cast<std::size_t>(facets_[i].parts) * facets_[i].parts;
            isAnyCut = isAnyCut || facets_[i].parts > 1;
        }
        if (triangles <= resolution.mostTriangles || !isAnyCut)
            return;
    }
}

void LightMesh::addTriangles(std::size_t number, const Probe& probe, Numbering& numbering) {
    const std::uint32_t piece = pieceOfFacet_[number];
    const RayMesh::Facet facet = mesh_->facet(piece, numberInPiece(number));
    Facet& own = facets_[number];
    own.first = static_cast<std::uint32_t>(corners_.size());
    const std::uint32_t parts = own.parts;
    const auto& c = facet.corners_m;
    const double area_m2 = 0.5 * length(cross(c[1] - c[0], c[2] - c[0])) / (parts * parts);
    const double least_m = nearest * probe.longest_m;
    for (std::uint32_t t = 0; t < parts * parts; ++t) {
        std::array<std::uint32_t, 3>& corners = corners_.emplace_back();
        facetOf_.push_back(static_cast<std::uint32_t>(number));
        const auto places = LatticeTriangle::of(t, parts).corners();
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] =
                numbering.at(piece, number, facet, places[k].first, places[k].second, parts);
            Vertex& vertex = vertices_[corners[k]];
            vertex.at_m = between(facet.corners_m, places[k].first, places[k].second, parts);
            vertex.normal = vertex.normal + own.normal * area_m2;
            double nearness_per_m2 = 0.0;
            for (const Vec3& seen_m : probe.seen_m) {
                const Vec3 apart = seen_m - vertex.at_m;
                nearness_per_m2 += 1.0 / std::max(dot(apart, apart), least_m * least_m);
            }
            vertex.nearness_per_m2 = std::max(vertex.nearness_per_m2, nearness_per_m2 / probe.rays);
        }
    }
}

LightMesh::Place LightMesh::placeOf(const RayHit& hit) const {
    const Facet& facet = facets_[firstFacet_[static_cast<std::size_t>(hit.piece)] + hit.facet];
    const std::uint32_t parts = facet.parts;
    const double u = std::clamp(hit.weights[1], 0.0, 1.0) * parts;
    const double v = std::clamp(hit.weights[2], 0.0, 1.0 - u / parts) * parts;
    LatticeTriangle found;
    found.i = std::min(static_cast<std::uint32_t>(u), parts - 1);
    found.j = std::min(static_cast<std::uint32_t>(v), parts - 1 - found.i);
    double a = std::min(u - found.i, 1.0), b = std::min(v - found.j, 1.0);
    found.isTurned = a + b > 1.0 && found.i + found.j + 1 < parts;
    if (found.isTurned) {
        a = 1.0 - a;
        b = 1.0 - b;
    }
    Place place;
    place.triangle = 2 * (facet.first + found.number(parts)) + (hit.isFront ? 0u : 1u);
    place.u = static_cast<float>(a);
    place.v = static_cast<float>(b);
    return place;
}

double LightMesh::area_m2(std::uint32_t triangle) const {
    const std::array<Vec3, 3> c = cornersAt_m(triangle);
    return 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
}

} // namespace irsg
