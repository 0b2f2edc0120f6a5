#include "irsg/geometry/mesh/MeshSurfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "irsg/core/JoinedNumbers.h"

namespace irsg {

std::vector<std::uint32_t> numbersOfPlaces(std::span<const Vec3> places_m, double step_m) {
    const double per_m = step_m > 0.0 ? 1.0 / step_m : 1.0;
    std::vector<std::pair<Vec3, std::uint32_t>> sorted; // in steps
    sorted.reserve(places_m.size());
    for (std::uint32_t i = 0; i < places_m.size(); ++i)
        sorted.emplace_back(Vec3{std::round(places_m[i].x * per_m),
                                 std::round(places_m[i].y * per_m),
                                 std::round(places_m[i].z * per_m)},
                            i);
    std::ranges::sort(sorted, [](const auto& a, const auto& b) {
        return std::tuple(a.first.x, a.first.y, a.first.z, a.second) <
               std::tuple(b.first.x, b.first.y, b.first.z, b.second);
    });
    std::vector<std::uint32_t> numbers(places_m.size());
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i > 0 && sorted[i].first != sorted[i - 1].first)
            ++number;
        numbers[sorted[i].second] = number;
    }
    return numbers;
}

std::vector<MeshSurface> surfacesOf(const Mesh& mesh) {
    std::vector<Vec3> corners_m; // three of each facet
    std::vector<bool> isTwoSided;
    for (const Mesh::Part& part : mesh.parts)
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k)
                corners_m.push_back(toVec3(part.vertices[part.triangles[i + k]]));
            isTwoSided.push_back(!part.culled);
        }
    const double size_m = mesh.bounds.valid() ? mesh.bounds.diagonal_m() : 0.0;
    const std::vector<std::uint32_t> places = numbersOfPlaces(corners_m, samePlaceOfSize * size_m);
    const auto isThere = [&](std::size_t f) {
        return places[3 * f] != places[3 * f + 1] && places[3 * f + 1] != places[3 * f + 2] &&
               places[3 * f + 2] != places[3 * f];
    };

    struct Edge {
        std::uint32_t low, high, facet;
        bool goesUp;
    };
    std::vector<Edge> edges;
    for (std::uint32_t f = 0; f < isTwoSided.size(); ++f)
        for (std::uint32_t i = 0; i < 3 && isThere(f); ++i) {
            const std::uint32_t from = places[3 * f + i], to = places[3 * f + (i + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), f, from < to});
        }
    std::ranges::sort(edges, {},
                      [](const Edge& edge) { return std::tuple(edge.low, edge.high, edge.facet); });
    JoinedNumbers joined(isTwoSided.size());
    std::vector<MeshSurface> byFacet(isTwoSided.size()); // by the lowest of a surface
    std::vector<std::array<std::size_t, 2>> bundles;     // edges that are one
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        for (; end < edges.size() && edges[end].low == edges[first].low &&
               edges[end].high == edges[first].high;
             ++end)
            joined.join(edges[end].facet, edges[first].facet);
        bundles.push_back({first, end});
    }
    for (const auto& [first, end] : bundles) {
        MeshSurface& own = byFacet[joined.of(edges[first].facet)];
        if (end - first == 1)
            ++own.openEdges;
        else if (end - first > 2)
            ++own.sharedEdges;
        else if (edges[first].goesUp == edges[first + 1].goesUp)
            ++own.flippedEdges;
    }
    for (std::size_t f = 0; f < isTwoSided.size(); ++f) {
        if (!isThere(f))
            continue;
        MeshSurface& own = byFacet[joined.of(static_cast<std::uint32_t>(f))];
        const Vec3& a = corners_m[3 * f];
        own.area_m2 += 0.5 * length(cross(corners_m[3 * f + 1] - a, corners_m[3 * f + 2] - a));
        ++own.facets;
        own.twoSidedFacets += isTwoSided[f] ? 1 : 0;
    }
    std::erase_if(byFacet, [](const MeshSurface& one) { return one.facets == 0; });
    std::ranges::stable_sort(byFacet, std::greater<>(), &MeshSurface::area_m2);
    return byFacet;
}

} // namespace irsg
