#include "irsg/render/rays/ExchangeMesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

#include "irsg/core/JoinedNumbers.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "irsg/render/rays/ExchangeMeshMaking.h"

namespace irsg {

ExchangeMesh::ExchangeMesh(std::shared_ptr<const RayMesh> mesh, const PieceUses& uses,
                           const ExchangeResolution& resolution)
    : mesh_(std::move(mesh)) {
    std::uint32_t facets = 0;
    for (std::uint32_t piece = 0; piece < mesh_->pieces(); ++piece) {
        firstFacet_.push_back(facets);
        facets += static_cast<std::uint32_t>(mesh_->facetsOf(piece));
    }
    std::vector<CellPair> uneven;
    {
        Making making{*mesh_, firstFacet_, uses, resolution};
        const BoundingBox all = making.takeFacets();
        extent_m_ = all.valid() ? all.diagonal_m() : 0.0;
        making.lift_m = lift_m();
        making.numberPlaces(samePlaceOfSize * extent_m_);
        making.findPassages();
        if (resolution.isAlone && resolution.hasInsides && making.isConvex(extent_m_)) {
            rootOf_.resize(making.sides(), nowhere);
            firstBeside_.push_back(0);
            return;
        }
        making.findWalls(extent_m_);
        making.sendProbes();
        making.findSpaces();
        {
            std::vector<std::uint32_t> large;
            const Making::CellSize size = making.chosenSize(extent_m_, large);
            fineness_ = size.fineness;
            making.refine(large, size);
        }
        addCells(making);
        uneven = joinVertices(making);
    }
    connectVertices(uneven);
}

template <typename Mesh, typename Archive>
void ExchangeMesh::visitKept(Mesh& mesh, Archive& archive) {
    archive(mesh.firstFacet_);
    archive(mesh.rootOf_);
    archive(mesh.splits_);
    archive(mesh.sideOf_);
    archive(mesh.othersBefore_);
    archive(mesh.onFacet_);
    archive(mesh.corners_);
    archive(mesh.sees_);
    archive(mesh.vertices_);
    archive(mesh.extent_m_);
    archive(mesh.fineness_);
}

std::shared_ptr<const ExchangeMesh> ExchangeMesh::read(std::shared_ptr<const RayMesh> mesh,
                                                       BinaryReader& reader) {
    std::shared_ptr<ExchangeMesh> made(new ExchangeMesh);
    visitKept(*made, reader);
    if (made->firstFacet_.size() != mesh->pieces() || made->rootOf_.size() != 2 * mesh->facets())
        return nullptr;
    made->mesh_ = std::move(mesh);
    return made;
}

void ExchangeMesh::write(BinaryWriter& writer) const {
    visitKept(*this, writer);
}

ExchangeMesh::Place ExchangeMesh::placeOf(const RayHit& hit) const {
    const std::size_t side =
        2 * static_cast<std::size_t>(firstFacet_[static_cast<std::size_t>(hit.piece)] + hit.facet) +
        (hit.isFront ? 0 : 1);
    const std::int32_t root = rootOf_[side];
    if (root == nowhere)
        return {};
    const double u = std::clamp(hit.weights[1], 0.0, 1.0);
    const double v = std::clamp(hit.weights[2], 0.0, 1.0 - u);
    Place place;
    place.cell = FacetDivision::cellOf({u, v}, root, splits_);
    if (root < 0) { // the only one of the side
        place.u = static_cast<float>(u);
        place.v = static_cast<float>(v);
        return place;
    }
    const auto& c = onFacet_[place.cell - othersBefore_[static_cast<std::size_t>(root)]];
    const double u0 = static_cast<double>(c[0][0]), v0 = static_cast<double>(c[0][1]);
    const double u1 = static_cast<double>(c[1][0]) - u0, v1 = static_cast<double>(c[1][1]) - v0;
    const double u2 = static_cast<double>(c[2][0]) - u0, v2 = static_cast<double>(c[2][1]) - v0;
    const double whole = u1 * v2 - u2 * v1;
    if (whole == 0.0)
        return place;
    const double second = std::clamp(((u - u0) * v2 - (v - v0) * u2) / whole, 0.0, 1.0);
    const double third = std::clamp(((v - v0) * u1 - (u - u0) * v1) / whole, 0.0, 1.0 - second);
    place.u = static_cast<float>(second);
    place.v = static_cast<float>(third);
    return place;
}

double ExchangeMesh::area_m2(std::uint32_t cell) const {
    const Triangle3 c = cornersAt_m(cell);
    return 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
}

Vec3 ExchangeMesh::normal(std::uint32_t cell) const {
    const std::uint32_t side = sideOf_[cell];
    const std::size_t piece = pieceOf(cell);
    const Triangle3 c = mesh_->facet(piece, side / 2 - firstFacet_[piece]).corners_m;
    const Vec3 across = crossed(c[1] - c[0], c[2] - c[0]);
    const Vec3 front = across == Vec3{} ? Vec3{0, 0, 1} : normalized(across);
    return side % 2 == 0 ? front : front * -1.0;
}

void ExchangeMesh::addCells(Making& making) {
    std::size_t cells = 0, ofCut = 0;
    for (std::uint32_t side = 0; side < making.sides(); ++side)
        if (making.isThere(side)) {
            const std::size_t own = making.divisionOf(side).cells().size();
            cells += own;
            ofCut += own > 1 ? own : 0;
        }
    sideOf_.reserve(cells);
    sees_.reserve(cells);
    onFacet_.reserve(ofCut);
    rootOf_.resize(making.sides(), nowhere);
    making.firstCell.clear();
    making.firstCell.reserve(making.sides());
    for (std::uint32_t side = 0; side < rootOf_.size(); ++side) {
        const auto first = static_cast<std::uint32_t>(sideOf_.size());
        making.firstCell.push_back(first);
        if (!making.isThere(side))
            continue;
        const FacetDivision& division = making.divisionOf(side);
        const auto firstSplit = static_cast<std::int32_t>(splits_.size());
        const auto moved = [&](std::int32_t at) {
            return at >= 0 ? at + firstSplit : at - static_cast<std::int32_t>(first);
        };
        rootOf_[side] = moved(division.root());
        for (Split one : division.splits()) {
            one.branches = {moved(one.branches[0]), moved(one.branches[1])};
            splits_.push_back(one);
        }
        const std::vector<FacetDivision::Cell>& own = division.cells();
        sideOf_.insert(sideOf_.end(), own.size(), side);
        sees_.insert(sees_.end(), own.size(), making.sees[side]);
        othersBefore_.resize(splits_.size(), first - static_cast<std::uint32_t>(onFacet_.size()));
        for (std::size_t cell = 0; own.size() > 1 && cell < own.size(); ++cell) {
            auto& places = onFacet_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                places[i] = {static_cast<float>(own[cell].corners[i].u),
                             static_cast<float>(own[cell].corners[i].v)};
        }
    }
}

std::vector<ExchangeMesh::CellPair> ExchangeMesh::joinVertices(Making& making) {
    const auto at_m = [&](std::uint32_t cell) {
        const std::uint32_t side = sideOf_[cell];
        const Triangle3 c = making.cornersOf(side / 2);
        if (!making.cut[side])
            return c;
        const auto& cells = making.cut[side]->cells();
        return Making::at(c, cells[cell - making.firstCell[side]].corners);
    };
    // Corners of cells that continue each other and lie at one place are one vertex.
    JoinedNumbers same(3 * cells());
    std::vector<CellPair> uneven;
    constexpr std::size_t atOnce = std::size_t{1} << 20;
    std::vector<std::array<std::uint32_t, 3>> beyond;
    for (std::size_t first = 0; first < cells(); first += atOnce) {
        beyond.resize(std::min(atOnce, cells() - first));
        parallelForSmall(beyond.size(), [&](std::uint32_t i) {
            const auto cell = static_cast<std::uint32_t>(first + i);
            const std::uint32_t side = sideOf_[cell], local = cell - making.firstCell[side];
            for (std::size_t edge = 0; edge < 3; ++edge)
                beyond[i][edge] = making.cellBeyond(side, local, edge, true);
        });
        for (std::uint32_t i = 0; i < beyond.size(); ++i) {
            const auto cell = static_cast<std::uint32_t>(first + i);
            const Triangle3 own_m = at_m(cell);
            const double ownLongest_m = longestEdgeOf(own_m);
            for (const std::uint32_t other : beyond[i]) {
                if (other == none)
                    continue;
                const Triangle3 other_m = at_m(other);
                const double near_m = 1e-4 * std::min(ownLongest_m, longestEdgeOf(other_m));
                const double farSquare_m2 = 2.0 * near_m * near_m; // no root is taken of most
                std::size_t common = 0;
                for (std::uint32_t k = 0; k < 3; ++k)
                    for (std::uint32_t l = 0; l < 3; ++l)
                        if (const Vec3 apart = own_m[k] - other_m[l];
                            product(apart, apart) < farSquare_m2 && plainLength(apart) < near_m) {
                            same.join(3 * cell + k, 3 * other + l);
                            ++common;
                        }
                if (common < 2)
                    uneven.emplace_back(cell, other);
            }
        }
    }
    beyond = {};
    making.passages = {};
    making.places = {};
    std::size_t vertices = 0;
    for (std::uint32_t corner = 0; corner < 3 * cells(); ++corner)
        vertices += same.of(corner) == corner ? 1 : 0;
    vertices_.reserve(vertices);
    sights_.reserve(vertices);
    corners_.resize(cells());
    for (std::uint32_t cell = 0; cell < cells(); ++cell) {
        const std::uint32_t side = sideOf_[cell], local = cell - making.firstCell[side];
        const std::uint32_t part = making.divisionOf(side).cells()[local].part;
        const Making::Probe& probe = making.probeAt(making.firstPart[side] + part);
        const Triangle3 c = at_m(cell);
        const double area_m2 = 0.5 * plainLength(crossed(c[1] - c[0], c[2] - c[0]));
        const Vec3 up = Making::normalOf(making.facetOf(side / 2), side);
        for (std::uint32_t i = 0; i < 3; ++i) {
            // Corners go by the lowest of those that are one: it has its number by then.
            const std::uint32_t corner = 3 * cell + i, lowest = same.of(corner);
            if (lowest == corner) {
                corners_[cell][i] = static_cast<std::uint32_t>(vertices_.size());
                vertices_.push_back(
                    {c[i], making.pieceOf[side / 2], making.spaces[making.firstPart[side] + part]});
                sights_.push_back({{}, 0.0, 0.0f});
            } else {
                corners_[cell][i] = corners_[lowest / 3][lowest % 3];
            }
            Sight& sight = sights_[corners_[cell][i]];
            sight.normal = sight.normal + up * area_m2;
            sight.nearness_per_m2 = std::max(sight.nearness_per_m2, probe.nearnessAt_per_m2(c[i]));
            sight.open = std::max(sight.open, probe.open());
        }
    }
    for (Sight& sight : sights_)
        sight.normal =
            sight.normal == Vec3{} ? Vec3{0, 0, 1} : sight.normal * (1.0 / length(sight.normal));
    return uneven;
}

void ExchangeMesh::forgetWays() {
    sights_ = {};
    firstBeside_ = {};
    beside_ = {};
}

void ExchangeMesh::connectVertices(const std::vector<CellPair>& uneven) {
    // Ways from some vertices after those from others: of millions they are not all there at once.
    constexpr std::size_t waysAtOnce = std::size_t{1} << 24;
    const std::size_t turns = 1 + 6 * cells() / waysAtOnce;
    std::vector<std::uint32_t> ends, ways;
    firstBeside_.assign(vertices_.size() + 1, 0);
    beside_.reserve(3 * cells()); // as many as there are about the vertices of a closed surface
    for (std::size_t turn = 0; turn < turns; ++turn) {
        const auto begin = static_cast<std::uint32_t>(vertices_.size() * turn / turns);
        const auto behind = static_cast<std::uint32_t>(vertices_.size() * (turn + 1) / turns);
        const auto forEachWay = [&](auto take) {
            const auto connect = [&](std::uint32_t a, std::uint32_t b) {
                if (a == b)
                    return;
                if (a >= begin && a < behind)
                    take(a - begin, b);
                if (b >= begin && b < behind)
                    take(b - begin, a);
            };
            for (const auto& c : corners_)
                for (std::size_t i = 0; i < 3; ++i)
                    connect(c[i], c[(i + 1) % 3]);
            for (const auto& [cell, other] : uneven)
                for (const std::uint32_t a : corners_[cell])
                    for (const std::uint32_t b : corners_[other])
                        connect(a, b);
        };
        // Counted, then put where those of the vertex begin, which is where they end afterwards.
        ends.assign(behind - begin + 1, 0);
        forEachWay([&](std::uint32_t from, std::uint32_t) { ++ends[from + 1]; });
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        ways.resize(ends.back());
        forEachWay([&](std::uint32_t from, std::uint32_t to) { ways[ends[from]++] = to; });
        for (std::uint32_t from = 0, first = 0; from < behind - begin; first = ends[from++]) {
            const auto own = std::span(ways).subspan(first, ends[from] - first);
            std::ranges::sort(own);
            const std::size_t several = std::ranges::unique(own).size();
            beside_.insert(beside_.end(), own.begin(),
                           own.end() - static_cast<std::ptrdiff_t>(several));
            firstBeside_[begin + from + 1] = static_cast<std::uint32_t>(own.size() - several);
        }
    }
    std::partial_sum(firstBeside_.begin(), firstBeside_.end(), firstBeside_.begin());
}

} // namespace irsg
