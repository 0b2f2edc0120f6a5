#include "irsg/geometry/mesh/MeshSurfaces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "irsg/core/JoinedNumbers.h"

namespace irsg {

namespace {

std::size_t hashOf(const Vec3& place) {
    std::uint64_t hash = 0;
    for (const double value : {place.x, place.y, place.z}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

} // namespace

void PlaceNumbers::grow() {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        std::size_t slot = hashOf(places_[i]) & mask;
        while (slots_[slot] != 0)
            slot = (slot + 1) & mask;
        slots_[slot] = static_cast<std::uint32_t>(i) + 1;
    }
}

std::uint32_t PlaceNumbers::of(const Vec3& place_m) {
    if (2 * places_.size() >= slots_.size())
        grow();
    // A zero has one sign.
    const Vec3 place{std::round(place_m.x * per_m_) + 0.0, std::round(place_m.y * per_m_) + 0.0,
                     std::round(place_m.z * per_m_) + 0.0};
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hashOf(place) & mask;
    for (; slots_[slot] != 0; slot = (slot + 1) & mask)
        if (places_[slots_[slot] - 1] == place)
            return slots_[slot] - 1;
    places_.push_back(place);
    slots_[slot] = static_cast<std::uint32_t>(places_.size());
    return slots_[slot] - 1;
}

std::vector<MeshSurface> surfacesOf(const Mesh& mesh) {
    std::vector<std::uint32_t> places; // three of each facet
    places.reserve(3 * mesh.facets());
    std::vector<double> areas_m2;
    areas_m2.reserve(mesh.facets());
    std::vector<bool> isTwoSided;
    const double size_m = mesh.bounds.valid() ? mesh.bounds.diagonal_m() : 0.0;
    PlaceNumbers numbers(samePlaceOfSize * size_m);
    for (const Mesh::Part& part : mesh.parts)
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            std::array<Vec3, 3> corners_m;
            for (std::size_t k = 0; k < 3; ++k) {
                corners_m[k] = toVec3(part.vertices[part.triangles[i + k]]);
                places.push_back(numbers.of(corners_m[k]));
            }
            areas_m2.push_back(
                0.5 * length(cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0])));
            isTwoSided.push_back(!part.culled);
        }
    const auto isThere = [&](std::size_t f) {
        return places[3 * f] != places[3 * f + 1] && places[3 * f + 1] != places[3 * f + 2] &&
               places[3 * f + 2] != places[3 * f];
    };

    struct Edge {
        std::uint32_t low, high, facet;
        bool goesUp;
    };
    std::vector<Edge> edges;
    edges.reserve(places.size());
    for (std::uint32_t f = 0; f < isTwoSided.size(); ++f)
        for (std::uint32_t i = 0; i < 3 && isThere(f); ++i) {
            const std::uint32_t from = places[3 * f + i], to = places[3 * f + (i + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), f, from < to});
        }
    std::ranges::sort(edges, {},
                      [](const Edge& edge) { return std::tuple(edge.low, edge.high, edge.facet); });
    JoinedNumbers joined(isTwoSided.size());
    std::map<std::uint32_t, MeshSurface> surfaces; // by the lowest facet
    // Calls visit(first, end) for the edges that are one.
    const auto forEachBundle = [&](const auto& visit) {
        for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
            while (end < edges.size() && edges[end].low == edges[first].low &&
                   edges[end].high == edges[first].high)
                ++end;
            visit(first, end);
        }
    };
    forEachBundle([&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            joined.join(edges[i].facet, edges[first].facet);
    });
    forEachBundle([&](std::size_t first, std::size_t end) {
        MeshSurface& own = surfaces[joined.of(edges[first].facet)];
        if (end - first == 1)
            ++own.openEdges;
        else if (end - first > 2)
            ++own.sharedEdges;
        else if (edges[first].goesUp == edges[first + 1].goesUp)
            ++own.flippedEdges;
    });
    for (std::size_t f = 0; f < isTwoSided.size(); ++f) {
        if (!isThere(f))
            continue;
        MeshSurface& own = surfaces[joined.of(static_cast<std::uint32_t>(f))];
        own.area_m2 += areas_m2[f];
        ++own.facets;
        own.twoSidedFacets += isTwoSided[f] ? 1 : 0;
    }
    std::vector<MeshSurface> byFacet;
    byFacet.reserve(surfaces.size());
    for (const auto& [facet, surface] : surfaces)
        byFacet.push_back(surface);
    std::ranges::stable_sort(byFacet, std::greater<>(), &MeshSurface::area_m2);
    return byFacet;
}

} // namespace irsg
