#include "irsg/radiance/exchange/LightNodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

constexpr std::size_t mostShares = 3;
/// Of the extent of a model: nodes stand no farther apart.
constexpr double longestOfExtent = 0.1;
/// Cosines between normals of vertices that a node stands for, and of those it has a part in.
constexpr double alike = 0.7, notUnlike = 0.5;
/// How far a node's part reaches, as a multiple of how far apart nodes are.
constexpr double reach = 1.5;

} // namespace

/// Nodes of one piece: a node never stands for two, which may be of different materials.
struct LightNodes::OfPiece {
    std::vector<std::uint32_t> vertices;
    std::vector<double> apart_m;            ///< by vertex: how far nodes may be
    std::vector<std::size_t> nodes;         ///< places among the vertices
    std::vector<std::vector<Share>> shares; ///< by vertex
};

LightNodes::LightNodes(std::shared_ptr<const LightMesh> mesh, const LightResolution& resolution)
    : mesh_(std::move(mesh)) {
    placeNodes(resolution);
    gatherPatches();
}

void LightNodes::placeNodes(const LightResolution& resolution) {
    const std::vector<LightMesh::Vertex>& vertices = mesh_->vertices();
    std::vector<OfPiece> pieces;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].piece >= pieces.size())
            pieces.resize(vertices[v].piece + 1);
        pieces[vertices[v].piece].vertices.push_back(v);
    }
    double longest_m = longestOfExtent * mesh_->extent_m();
    if (resolution.longestEdge_m > 0.0)
        longest_m = std::min(longest_m, resolution.longestEdge_m);
    for (double edge = resolution.edgePerDistance;; edge *= 1.4, longest_m *= 1.2) {
        parallelFor(pieces.size(),
                    [&](std::size_t p) { place(pieces[p], *mesh_, edge, longest_m); });
        std::size_t nodes = 0;
        for (const OfPiece& piece : pieces)
            nodes += piece.nodes.size();
        // However far apart, each piece and each way that it looks has one.
        constexpr double mostStretched = 100.0;
        if (nodes <= resolution.mostNodes || edge > mostStretched * resolution.edgePerDistance)
            break;
    }
    parallelFor(pieces.size(), [&](std::size_t p) { share(pieces[p], *mesh_); });

    std::vector<std::pair<const std::vector<Share>*, std::uint32_t>> ofVertex(vertices.size());
    for (std::uint32_t p = 0; p < pieces.size(); ++p) {
        const auto before = static_cast<std::uint32_t>(nodes());
        pieceOf_.insert(pieceOf_.end(), pieces[p].nodes.size(), p);
        for (std::size_t i = 0; i < pieces[p].vertices.size(); ++i)
            ofVertex[pieces[p].vertices[i]] = {&pieces[p].shares[i], before};
    }
    firstShare_.push_back(0);
    for (const auto& [shares, before] : ofVertex) {
        for (const Share& one : *shares)
            shares_.push_back({one.node + before, one.part});
        firstShare_.push_back(static_cast<std::uint32_t>(shares_.size()));
    }
}

void LightNodes::place(OfPiece& piece, const LightMesh& mesh, double edge, double longest_m) {
    const auto vertexAt = [&](std::size_t i) -> const LightMesh::Vertex& {
        return mesh.vertices()[piece.vertices[i]];
    };
    piece.apart_m.clear();
    for (std::size_t i = 0; i < piece.vertices.size(); ++i)
        piece.apart_m.push_back(
            std::min(longest_m, edge / std::sqrt(std::max(vertexAt(i).nearness_per_m2, 1e-30))));
    piece.nodes.clear();
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
        const LightMesh::Vertex& own = vertexAt(i);
        const bool isCovered = std::ranges::any_of(piece.nodes, [&](std::size_t n) {
            const LightMesh::Vertex& node = vertexAt(n);
            const Vec3 apart = node.at_m - own.at_m;
            const double most_m = std::min(piece.apart_m[i], piece.apart_m[n]);
            return dot(apart, apart) < most_m * most_m && dot(node.normal, own.normal) > alike;
        });
        if (!isCovered)
            piece.nodes.push_back(i);
    }
}

void LightNodes::share(OfPiece& piece, const LightMesh& mesh) {
    std::vector<std::pair<double, std::uint32_t>> found;
    piece.shares.assign(piece.vertices.size(), {});
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
        const LightMesh::Vertex& own = mesh.vertices()[piece.vertices[i]];
        found.clear();
        for (std::uint32_t n = 0; n < piece.nodes.size(); ++n) {
            const LightMesh::Vertex& node = mesh.vertices()[piece.vertices[piece.nodes[n]]];
            const double most_m = reach * std::min(piece.apart_m[i], piece.apart_m[piece.nodes[n]]);
            const Vec3 apart = node.at_m - own.at_m;
            const double far = 1.0 - dot(apart, apart) / (most_m * most_m);
            const double turned =
                piece.nodes[n] == i ? 1.0 : dot(node.normal, own.normal) - notUnlike;
            if (piece.nodes[n] == i)
                found.emplace_back(1.0 - notUnlike, n);
            else if (far > 0.0 && turned > 0.0)
                found.emplace_back(far * far * turned, n);
        }
        std::ranges::stable_sort(found, std::greater<>(), &std::pair<double, std::uint32_t>::first);
        found.resize(std::min(found.size(), mostShares));
        double sum = 0.0;
        for (const auto& [weight, node] : found)
            sum += weight;
        for (const auto& [weight, node] : found)
            piece.shares[i].push_back({node, static_cast<float>(weight / sum)});
    }
}

void LightNodes::gatherPatches() {
    const std::size_t triangles = mesh_->triangles();
    std::vector<std::uint32_t> patchOf(triangles);
    parallelFor(16, [&](std::size_t part) {
        std::vector<Share> sums;
        for (std::size_t t = beginOfPart(part, 16, triangles);
             t < beginOfPart(part + 1, 16, triangles); ++t) {
            sums.clear();
            for (const std::uint32_t corner : mesh_->corners(static_cast<std::uint32_t>(t)))
                for (const Share& one : sharesOf(corner)) {
                    const auto known = std::ranges::find(sums, one.node, &Share::node);
                    if (known != sums.end())
                        known->part += one.part;
                    else
                        sums.push_back(one);
                }
            patchOf[t] = std::ranges::max_element(sums, {}, &Share::part)->node;
        }
    });
    first_.assign(nodes() + 1, 0);
    for (const std::uint32_t patch : patchOf)
        ++first_[patch + 1];
    for (std::size_t p = 0; p < nodes(); ++p)
        first_[p + 1] += first_[p];
    triangles_.resize(triangles);
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles; ++t)
        triangles_[next[patchOf[t]]++] = t;

    area_m2_.assign(nodes(), 0.0);
    areaUpTo_m2_.resize(triangles);
    firstNear_.push_back(0);
    std::vector<std::pair<std::uint32_t, double>> areas;
    for (std::uint32_t patch = 0; patch < nodes(); ++patch) {
        areas.clear();
        double sum_m2 = 0.0;
        for (std::uint32_t i = first_[patch]; i < first_[patch + 1]; ++i) {
            const double area_m2 = mesh_->area_m2(triangles_[i]);
            areaUpTo_m2_[i] = sum_m2 += area_m2;
            for (const std::uint32_t corner : mesh_->corners(triangles_[i]))
                for (const Share& one : sharesOf(corner))
                    areas.emplace_back(one.node, static_cast<double>(one.part) * area_m2 / 3.0);
        }
        std::ranges::stable_sort(areas, {}, &std::pair<std::uint32_t, double>::first);
        for (std::size_t i = 0; i < areas.size();) {
            const std::uint32_t node = areas[i].first;
            double own_m2 = 0.0;
            for (; i < areas.size() && areas[i].first == node; ++i)
                own_m2 += areas[i].second;
            area_m2_[node] += own_m2;
            near_.push_back({node, static_cast<float>(own_m2)});
        }
        firstNear_.push_back(static_cast<std::uint32_t>(near_.size()));
    }
}

LightNodes::OfPlace::OfPlace(const LightNodes& nodes, const LightMesh::Place& place) {
    static_assert(3 * mostShares == std::tuple_size_v<decltype(shares_)>);
    const auto& corners = nodes.mesh().corners(place.triangle / 2);
    const std::array<float, 3> parts{1.0f - place.u - place.v, place.u, place.v};
    for (std::size_t c = 0; c < 3; ++c)
        for (const Share& share : nodes.sharesOf(corners[c])) {
            const auto end = shares_.begin() + static_cast<std::ptrdiff_t>(count_);
            const auto known = std::find_if(
                shares_.begin(), end, [&](const Share& one) { return one.node == share.node; });
            if (known != end)
                known->part += parts[c] * share.part;
            else
                shares_[count_++] = {share.node, parts[c] * share.part};
        }
}

std::size_t LightNodes::placeNear(std::uint32_t patch, std::uint32_t node) const {
    const std::span<const Near> all = near(patch);
    return static_cast<std::size_t>(std::ranges::lower_bound(all, node, {}, &Near::node) -
                                    all.begin());
}

bool LightNodes::seesAnything(std::uint32_t side) const {
    return std::ranges::any_of(trianglesOf(side / 2), [&](std::uint32_t triangle) {
        return mesh_->seesAnything(triangle, side % 2 == 0);
    });
}

LightNodes::Start LightNodes::start(std::uint32_t side, double which, double a, double b) const {
    const std::uint32_t patch = side / 2;
    const auto begin = areaUpTo_m2_.begin() + first_[patch];
    const auto end = areaUpTo_m2_.begin() + first_[patch + 1] - 1;
    const auto found = std::upper_bound(begin, end, which * patchArea_m2(patch));
    const std::uint32_t triangle =
        triangles_[static_cast<std::size_t>(found - areaUpTo_m2_.begin())];
    const double root = std::sqrt(a);
    const double u = root * (1.0 - b), v = root * b;
    const std::array<Vec3, 3> c = mesh_->cornersAt_m(triangle);
    Start start;
    start.place = {2 * triangle + side % 2, static_cast<float>(u), static_cast<float>(v)};
    start.normal = side % 2 == 0 ? mesh_->normal(triangle) : mesh_->normal(triangle) * -1.0;
    start.at_m =
        c[0] * (1.0 - u - v) + c[1] * u + c[2] * v + start.normal * (1e-6 * mesh_->extent_m());
    return start;
}

} // namespace irsg
