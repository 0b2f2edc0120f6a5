#include <cmath>
#include <numeric>
#include <tuple>

#include "irsg/core/Errors.h"
#include "irsg/core/JoinedNumbers.h"
#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/ExchangeMeshMaking.h"

namespace irsg {

namespace {

/// Cosine of the normals of sides that continue each other smoothly.
constexpr double alike = 0.5;
/// The same, either way, of facets that are one surface seen from afar.
constexpr double flush = 0.9;
/// Edges that are put in order at once.
constexpr std::size_t edgesAtOnce = std::size_t{1} << 22;

} // namespace

BoundingBox ExchangeMesh::Making::takeFacets() {
    if (2 * mesh.facets() >= Passage::nowhere)
        throw InputError({"inter-reflection", "", std::to_string(mesh.facets()) + " facets",
                          "fewer than " + std::to_string(Passage::nowhere / 2)});
    BoundingBox all = BoundingBox::nowhere();
    pieceOf.reserve(mesh.facets());
    hasArea.reserve(mesh.facets());
    for (std::uint32_t piece = 0; piece < mesh.pieces(); ++piece) {
        corners.push_back(mesh.cornersOf(piece));
        const bool isOpaque = uses[piece].isThere && !uses[piece].transparent;
        roles.push_back({isOpaque || uses[piece].pane > 0, isOpaque,
                         uses[piece].cullsBackFaces && !uses[piece].transparent});
        for (unsigned f = 0; f < mesh.facetsOf(piece); ++f) {
            pieceOf.push_back(piece);
            const Triangle3 c = corners.back().of(f);
            const double own_m2 = 0.5 * length(crossed(c[1] - c[0], c[2] - c[0]));
            hasArea.push_back(own_m2 > 0.0);
            area_m2 += own_m2;
            for (const Vec3& corner : c)
                all.include(corner);
        }
    }
    outlines.assign(facets(), 7);
    return all;
}

ExchangeMesh::Making::Facet ExchangeMesh::Making::facetOf(std::uint32_t facet) const {
    Facet found;
    const Triangle3& c = found.corners_m = cornersOf(facet);
    found.piece = pieceOf[facet];
    const Vec3 across = crossed(c[1] - c[0], c[2] - c[0]);
    found.normal = across == Vec3{} ? Vec3{0, 0, 1} : normalized(across);
    found.area_m2 = 0.5 * length(across);
    found.longest_m = longestEdgeOf(c);
    return found;
}

/// Whether all that is there is one closed opaque surface that is convex at every edge: then it is
/// convex (van Heijenoort, Comm. Pure Appl. Math. 5, 223, 1952).
bool ExchangeMesh::Making::isConvex(double extent_m) const {
    JoinedNumbers joined(facets());
    std::uint32_t first = none;
    const auto isThereAtAll = [&](std::uint32_t f) {
        return uses[pieceOf[f]].isThere && hasArea[f];
    };
    for (std::uint32_t f = 0; f < facets(); ++f) {
        if (!isThereAtAll(f))
            continue;
        first = std::min(first, f);
        const Facet own = facetOf(f);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            // Beyond each edge of the front lies the front of one neighbour, which falls away.
            const Passage& passage = passages[2 * f][edge];
            if (!roles[own.piece].isOpaque || passage.side == Passage::nowhere ||
                passage.side % 2 != 0 || passage.isOneOfMany)
                return false;
            const Vec3 third = cornersOf(passage.side / 2)[(passage.edge + 2) % 3];
            if (product(own.normal, third - own.corners_m[0]) > flatOfExtent * extent_m)
                return false;
            joined.join(f, passage.side / 2);
        }
    }
    for (std::uint32_t f = 0; f < facets(); ++f)
        if (isThereAtAll(f) && joined.of(f) != first)
            return false;
    return true;
}

void ExchangeMesh::Making::numberPlaces(double step_m) {
    PlaceNumbers numbers(step_m);
    places.resize(facets());
    for (std::uint32_t f = 0; f < facets(); ++f) {
        const Triangle3 c = cornersOf(f);
        for (std::size_t i = 0; i < 3; ++i)
            places[f][i] = numbers.of(c[i]);
    }
}

void ExchangeMesh::Making::findPassages() {
    struct Edge {
        std::uint32_t from, to; // places
        std::uint32_t facet, edge;
    };
    passages.resize(sides());
    std::uint32_t allPlaces = 0;
    for (const auto& own : places)
        allPlaces = std::max(allPlaces, std::ranges::max(own) + 1);
    // Edges from some places after those from others: of millions they are not all there at once.
    const std::size_t turns = 1 + 3 * facets() / edgesAtOnce;
    std::vector<Edge> edges;
    std::vector<std::uint32_t> ends; // by place: where its edges end so far
    std::vector<FacetAtEdge> about;
    for (std::size_t turn = 0; turn < turns; ++turn) {
        const auto begin = static_cast<std::uint32_t>(allPlaces * turn / turns);
        const auto behind = static_cast<std::uint32_t>(allPlaces * (turn + 1) / turns);
        const auto forEachEdge = [&](auto take) {
            for (std::uint32_t f = 0; f < facets(); ++f)
                for (std::uint32_t i = 0; i < 3 && hasArea[f]; ++i) {
                    const std::uint32_t a = places[f][i], b = places[f][(i + 1) % 3];
                    if (const std::uint32_t from = std::min(a, b); from >= begin && from < behind)
                        take(Edge{from, std::max(a, b), f, i});
                }
        };
        ends.assign(behind - begin + 1, 0);
        forEachEdge([&](const Edge& edge) { ++ends[edge.from - begin + 1]; });
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        edges.resize(ends.back());
        forEachEdge([&](const Edge& edge) { edges[ends[edge.from - begin]++] = edge; });
        for (std::uint32_t place = 0, first = 0; place < behind - begin; first = ends[place++])
            std::sort(edges.begin() + first, edges.begin() + ends[place],
                      [](const Edge& a, const Edge& b) {
                          return std::tuple(a.to, a.facet, a.edge) <
                                 std::tuple(b.to, b.facet, b.edge);
                      });
        for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
            while (end < edges.size() && edges[end].from == edges[first].from &&
                   edges[end].to == edges[first].to)
                ++end;
            if (end - first < 2)
                continue;
            about.clear();
            for (std::size_t i = first; i < end; ++i)
                about.push_back({edges[i].facet, edges[i].edge, facetOf(edges[i].facet)});
            for (const FacetAtEdge& own : about)
                if (std::ranges::any_of(
                        about, [&](const FacetAtEdge& other) { return continues(own, other); }))
                    outlines[own.facet] =
                        static_cast<std::uint8_t>(outlines[own.facet] & ~(1u << own.edge));
            for (const FacetAtEdge& own : about)
                for (std::uint32_t side = 2 * own.facet; side < 2 * own.facet + 2; ++side)
                    if (isThere(side))
                        passages[side][own.edge] = passageFrom(side, own, about);
        }
    }
}

/// Whether another facet lies beyond an edge, almost in the plane of this one: not its own copy
/// that turns the other way.
bool ExchangeMesh::Making::continues(const FacetAtEdge& own, const FacetAtEdge& other) {
    const Vec3& from = own.values.corners_m[own.edge];
    const Vec3 along = own.values.corners_m[(own.edge + 1) % 3] - from;
    const auto isLeft = [&](const FacetAtEdge& one) {
        const Vec3 third = one.values.corners_m[(one.edge + 2) % 3] - from;
        return product(crossed(along, third), own.values.normal) > 0.0;
    };
    return other.facet != own.facet &&
           std::abs(product(other.values.normal, own.values.normal)) > flush &&
           isLeft(other) != isLeft(own);
}

/// About an edge, from a side, the next facet is where one gets: the one that turns its own side
/// towards the wedge between them.
ExchangeMesh::Making::Passage
ExchangeMesh::Making::passageFrom(std::uint32_t side, const FacetAtEdge& own,
                                  std::span<const FacetAtEdge> about) const {
    const Vec3& from = own.values.corners_m[own.edge];
    const Vec3 along = own.values.corners_m[(own.edge + 1) % 3] - from;
    const Vec3 up = normalOf(own.values, side);
    const double square = product(along, along);
    const auto inward = [&](const FacetAtEdge& one) {
        const Vec3 to = one.values.corners_m[(one.edge + 2) % 3] - from;
        return to - along * (product(to, along) / square);
    };
    const Vec3 in = inward(own);
    const Vec3 right = in * (1.0 / plainLength(in));
    double least = 4.0 * pi;
    Passage next;
    for (const FacetAtEdge& other : about) {
        if (other.facet == own.facet ||
            !(roles[other.values.piece].isMet || other.values.piece == own.values.piece))
            continue;
        const Vec3 there = inward(other);
        double angle = std::atan2(product(there, up), product(there, right));
        angle += angle <= 0.0 ? 2.0 * pi : 0.0;
        if (angle >= least)
            continue;
        least = angle;
        const Vec3 ahead = up * std::cos(angle) - right * std::sin(angle);
        const std::uint32_t turned = product(other.values.normal, ahead) < 0.0 ? 0u : 1u;
        next.side = (2 * other.facet + turned) & Passage::nowhere;
        next.edge = other.edge & 3u;
        next.isSmooth = other.values.piece == own.values.piece &&
                        product(normalOf(other.values, next.side), up) > alike;
        next.isOneOfMany = about.size() > 2;
    }
    return next.side != Passage::nowhere && isThere(next.side) ? next : Passage{};
}

std::uint32_t ExchangeMesh::Making::cellBeyond(std::uint32_t side, std::uint32_t cell,
                                               std::size_t edge, bool isSmooth) const {
    if (!cut[side]) { // as nearly all of a large model: edges of the cell are those of the facet
        const Passage& passage = passages[side][edge];
        if (passage.side == Passage::nowhere || (isSmooth && !passage.isSmooth))
            return none;
        if (!cut[passage.side])
            return firstCell[passage.side];
    }
    const FacetDivision& division = divisionOf(side);
    const FacetDivision::Triangle& corners = division.cells()[cell].corners;
    const FacetPlace from = corners[edge], way = corners[(edge + 1) % 3] - from;
    const FacetPlace middle = from + way * 0.5;
    const double step = 2.0 * toleranceOf(side) / std::hypot(way.u, way.v);
    const FacetPlace out{way.v * step, -way.u * step};
    const FacetPlace before = middle - out, behind = middle + out;
    if (division.isBetween(cell, before, behind))
        return none;
    const std::array<double, 3> weights{1.0 - behind.u - behind.v, behind.u, behind.v};
    const auto outside =
        static_cast<std::size_t>(std::ranges::min_element(weights) - weights.begin());
    if (weights[outside] > 0.0) {
        const std::uint32_t other = division.cellOf(behind);
        return other == cell || division.isBetween(other, before, behind) ? none
                                                                          : firstCell[side] + other;
    }
    // Across the edge of the facet that lies opposite that corner.
    const std::size_t begin = (outside + 1) % 3, end = (outside + 2) % 3;
    const Passage& passage = passages[side][begin];
    if (passage.side == Passage::nowhere || (isSmooth && !passage.isSmooth))
        return none;
    const std::array<double, 3> at{1.0 - middle.u - middle.v, middle.u, middle.v};
    const double part = std::clamp(at[end] / std::max(at[begin] + at[end], 1e-30), 0.0, 1.0);
    const FacetDivision& there = divisionOf(passage.side);
    const bool isReversed = places[passage.side / 2][passage.edge] == places[side / 2][end];
    const double along = isReversed ? 1.0 - part : part;
    const auto placeAt = [&](double inward) {
        std::array<double, 3> w{};
        w[passage.edge] = (1.0 - along) * (1.0 - inward);
        w[(passage.edge + 1) % 3] = along * (1.0 - inward);
        w[(passage.edge + 2) % 3] = inward;
        return FacetPlace{w[1], w[2]};
    };
    const double width = 2.0 * toleranceOf(passage.side);
    const std::uint32_t found = there.cellOf(placeAt(width));
    return there.isBetween(found, placeAt(-width), placeAt(width))
               ? none
               : firstCell[passage.side] + found;
}

} // namespace irsg
