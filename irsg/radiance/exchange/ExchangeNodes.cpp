#include "irsg/radiance/exchange/ExchangeNodes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "irsg/core/Errors.h"
#include "irsg/core/JoinedNumbers.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"
#include "irsg/radiance/exchange/SurfaceWays.h"

namespace irsg {

namespace {

constexpr std::size_t mostShares = 3;
/// Cosines between normals of vertices that a node stands for, and of those it has a part in.
constexpr double alike = 0.7, notUnlike = 0.5;
/// How far a node's part reaches, as a multiple of how far apart nodes are.
constexpr double reach = 1.5;
/// Area of a surface that is no more than a detail, of the square of how far nodes are apart.
constexpr double smallSurface = 0.5;

/// Finds vertices by where they are.
class Neighbourhood {
  public:
    /// Finds those no farther away than `width_m`.
    explicit Neighbourhood(double width_m) : width_m_(width_m) {}
    void add(std::size_t place, const Vec3& at_m) { boxes_[boxOf(at_m)].push_back(place); }
    /// Calls visit(place) for all of them, and some that are farther away.
    template <typename Visit>
    void forEachAbout(const Vec3& at_m, Visit visit) const {
        const Box middle = boxOf(at_m);
        for (long x = middle[0] - 1; x <= middle[0] + 1; ++x)
            for (long y = middle[1] - 1; y <= middle[1] + 1; ++y)
                for (long z = middle[2] - 1; z <= middle[2] + 1; ++z)
                    if (const auto found = boxes_.find({x, y, z}); found != boxes_.end())
                        for (const std::size_t place : found->second)
                            visit(place);
    }

  private:
    using Box = std::array<long, 3>;
    Box boxOf(const Vec3& at_m) const {
        return {std::lround(at_m.x / width_m_), std::lround(at_m.y / width_m_),
                std::lround(at_m.z / width_m_)};
    }
    double width_m_;
    std::map<Box, std::vector<std::size_t>> boxes_;
};

/// By vertex: the area of the surface that is connected with it.
std::vector<double> surfacesOf_m2(const ExchangeMesh& mesh) {
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices().size());
    JoinedNumbers surfaces(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v)
        for (const std::uint32_t next : mesh.beside(v))
            surfaces.join(v, next);
    std::vector<double> areas_m2(vertices), byVertex_m2;
    byVertex_m2.reserve(vertices);
    for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell)
        areas_m2[surfaces.of(mesh.corners(cell)[0])] += mesh.area_m2(cell);
    for (std::uint32_t v = 0; v < vertices; ++v)
        byVertex_m2.push_back(areas_m2[surfaces.of(v)]);
    return byVertex_m2;
}

} // namespace

/// The nodes of a vertex with their weights, the largest first; of equal ones the first that came.
/// Of large models there are millions, so that they are no lists.
struct ExchangeNodes::FewNodes {
    std::array<double, mostShares> weights{};
    std::array<std::uint32_t, mostShares> nodes{};
    std::uint32_t count = 0;

    void offer(double weight, std::uint32_t node) {
        std::size_t at = count;
        while (at > 0 && weights[at - 1] < weight)
            --at;
        if (at == mostShares)
            return;
        count = std::min<std::uint32_t>(count + 1, mostShares);
        for (std::size_t i = count - 1; i > at; --i) {
            weights[i] = weights[i - 1];
            nodes[i] = nodes[i - 1];
        }
        weights[at] = weight;
        nodes[at] = node;
    }
};

/// Nodes of one piece: a node never stands for two, which may be of different materials.
struct ExchangeNodes::OfPiece {
    std::uint32_t first = 0, count = 0;   ///< its vertices follow each other
    std::vector<double> apart_m;          ///< by vertex: how far nodes may be
    std::vector<std::size_t> nodes;       ///< places among the vertices
    std::uint32_t firstNode = 0;          ///< number of the first of them
    std::vector<double> surface_m2;       ///< by vertex: of all that one can go to
    std::vector<std::uint32_t> coveredBy; ///< by vertex: among the nodes
    std::vector<FewNodes> shares;         ///< by vertex
};

ExchangeNodes::ExchangeNodes(std::shared_ptr<const ExchangeMesh> mesh,
                             const ExchangeResolution& resolution)
    : mesh_(std::move(mesh)) {
    placeNodes(resolution);
    gatherPatches();
    findSmoothing();
}

void ExchangeNodes::findSmoothing() {
    // What is linear over a cell of area A has A/12 (d + 1) between two corners, d at one and the
    // same: a part of what is around each vertex, and the rest over the cell as a whole.
    std::vector<double> quarter_m2(mesh_->vertices().size());
    for (std::uint32_t cell = 0; cell < mesh_->cells(); ++cell) {
        const double twelfth_m2 = mesh_->area_m2(cell) / 12.0;
        for (const std::uint32_t corner : mesh_->corners(cell))
            quarter_m2[corner] += twelfth_m2;
    }
    // Nodes are near few others: of each pair the parts are summed as they come.
    std::vector<std::vector<LightPart>> parts(nodes());
    const auto add = [&](const LightPart& part) {
        std::vector<LightPart>& own = parts[part.receiver];
        const auto known = std::ranges::find(own, part.sender, &LightPart::sender);
        if (known == own.end())
            own.push_back(part);
        else
            known->factor += part.factor;
    };
    const auto addAll = [&](const auto& shares, double product_m2) {
        for (const Share& one : shares)
            for (const Share& other : shares)
                if (area_m2_[one.node] > 0.0)
                    add({one.node, other.node,
                         one.part * other.part *
                             static_cast<float>(product_m2 / area_m2_[one.node])});
    };
    for (std::uint32_t v = 0; v < quarter_m2.size(); ++v)
        addAll(sharesOf(v), quarter_m2[v]);
    // The three corners together are the place in the middle of the cell, times 3.
    constexpr float third = 1.0f / 3.0f;
    for (std::uint32_t cell = 0; cell < mesh_->cells(); ++cell)
        addAll(OfPlace(*this, {cell, third, third}), 0.75 * mesh_->area_m2(cell));
    smoothing_ = LightPairs(nodes(), std::move(parts));
    findSmoothingOfSenders();
}

void ExchangeNodes::findSmoothingOfSenders() {
    std::vector<double> sending_m2(senders_);
    for (std::uint32_t node = 0; node < nodes(); ++node)
        sending_m2[senderOf_[node]] += area_m2_[node];
    std::vector<std::vector<LightPart>> parts(nodes());
    for (std::uint32_t node = 0; node < nodes(); ++node) {
        const auto [first, last] = smoothing_.of(node);
        for (const LightPair* pair = first; pair != last; ++pair)
            parts[node].push_back(
                {senderOf_[node], senderOf_[pair->sender],
                 pair->factor * static_cast<float>(area_m2_[node] / sending_m2[senderOf_[node]])});
    }
    smoothingOfSenders_ = LightPairs(senders_, std::move(parts));
}

void ExchangeNodes::placeNodes(const ExchangeResolution& resolution) {
    const std::vector<ExchangeMesh::Vertex>& vertices = mesh_->vertices();
    std::vector<OfPiece> pieces;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].piece >= pieces.size())
            pieces.resize(vertices[v].piece + 1);
        OfPiece& own = pieces[vertices[v].piece];
        own.first = own.count == 0 ? v : own.first;
        if (own.first + own.count++ != v)
            throw LogicError("vertices of a piece that do not follow each other");
    }
    {
        const std::vector<double> surfaces_m2 = surfacesOf_m2(*mesh_);
        for (OfPiece& piece : pieces)
            piece.surface_m2.assign(surfaces_m2.begin() + piece.first,
                                    surfaces_m2.begin() + piece.first + piece.count);
    }
    double area_m2 = 0.0;
    for (std::uint32_t cell = 0; cell < mesh_->cells(); ++cell)
        area_m2 += mesh_->area_m2(cell);
    bool isLimited = false;
    const auto spacingWith = [&](double fineness, double least_m) {
        NodeSpacing spacing{fineness * resolution.edgePerDistance, least_m,
                            fineness * resolution.longestOfExtent * mesh_->extent_m()};
        if (resolution.longestEdge_m > 0.0)
            spacing.longest_m = std::min(spacing.longest_m, resolution.longestEdge_m);
        spacing.longest_m = std::max(spacing.longest_m, least_m);
        spacing.spareDark = isLimited;
        return spacing;
    };
    const auto fits = [&](double fineness, double least_m, std::size_t most) {
        return placeAll(pieces, *mesh_, spacingWith(fineness, least_m), most);
    };
    // Simple models have finer ones: the finest that does, from the coarsest on, which takes the
    // least time to find out about.
    const double finest_m = 0.25 * std::sqrt(area_m2 / static_cast<double>(resolution.mostNodes));
    double least_m = finest_m;
    std::vector<double> finer{mesh_->fineness()};
    while (finer.back() < 0.99)
        finer.push_back(finer.back() * std::sqrt(2.0));
    while (finer.size() > 1 && fits(finer[finer.size() - 2], least_m, resolution.fewNodes))
        finer.pop_back();
    fineness_ = finer.back();
    // Small ones are left out first where there would be too many: what is small matters less.
    // However far apart, each piece and each way that it looks has one.
    const bool isFine = fineness_ < 0.99;
    ExchangeResolution limits = resolution;
    while (!isFine && !fits(1.0, least_m, limits.mostNodes) && least_m < mesh_->extent_m()) {
        isLimited = true;
        least_m *= 1.2;
        if (limits.mostNodes < resolution.mostNodesOfDetail &&
            least_m > resolution.mostCoarseness * finest_m) {
            limits.mostNodes = resolution.mostNodesOfDetail;
            limits.mostSenders = resolution.mostSendersOfDetail;
            least_m = finest_m;
        }
    }
    if (isFine || least_m >= mesh_->extent_m())
        placeAll(pieces, *mesh_, spacingWith(isFine ? fineness_ : 1.0, least_m), allNodes);
    coarseness_ = finest_m > 0.0 ? least_m / finest_m : 1.0;
    takeShares(pieces);
    placeSenders(pieces, spacingWith(fineness_, least_m), limits);
}

/// Vertices are numbered piece by piece, so that some pieces at once do.
void ExchangeNodes::takeShares(std::vector<OfPiece>& pieces) {
    constexpr std::size_t atOnce = 16;
    firstShare_.reserve(mesh_->vertices().size() + 1);
    firstShare_.push_back(0);
    shares_.reserve(mostShares * mesh_->vertices().size());
    StageCount done("surfaces", pieces.size());
    for (std::size_t first = 0; first < pieces.size(); first += atOnce) {
        const std::size_t count = std::min(atOnce, pieces.size() - first);
        parallelFor(count, [&](std::size_t i) { share(pieces[first + i], *mesh_); });
        for (std::size_t p = first; p < first + count; ++p) {
            OfPiece& piece = pieces[p];
            piece.firstNode = static_cast<std::uint32_t>(nodes());
            pieceOf_.insert(pieceOf_.end(), piece.nodes.size(), static_cast<std::uint32_t>(p));
            for (std::size_t i = 0; i < piece.count; ++i) {
                const FewNodes& few = piece.shares[i];
                double sum = 0.0;
                for (std::size_t k = 0; k < few.count; ++k)
                    sum += few.weights[k];
                for (std::size_t k = 0; k < few.count; ++k)
                    shares_.push_back(
                        {few.nodes[k] + piece.firstNode, static_cast<float>(few.weights[k] / sum)});
                firstShare_.push_back(static_cast<std::uint32_t>(shares_.size()));
            }
            piece.shares = {};
        }
        done.add(count);
    }
}

bool ExchangeNodes::placeAll(std::vector<OfPiece>& pieces, const ExchangeMesh& mesh,
                             const NodeSpacing& spacing, std::size_t most) {
    std::atomic<std::size_t> outside = 0;
    parallelFor(pieces.size(), [&](std::size_t p) {
        if (outside <= most)
            place(pieces[p], mesh, spacing, most, outside);
    });
    return outside <= most;
}

/// Nodes send as one that would be one where nodes are farther apart.
void ExchangeNodes::placeSenders(std::vector<OfPiece>& pieces, NodeSpacing spacing,
                                 const ExchangeResolution& resolution) {
    constexpr double widest = 2.0, step = 1.19;
    senderOf_.resize(nodes());
    std::iota(senderOf_.begin(), senderOf_.end(), 0u);
    senders_ = nodes();
    if (nodes() <= resolution.fewSenders)
        return;
    std::vector<std::vector<std::size_t>> nodesOf; // by piece
    nodesOf.reserve(pieces.size());
    for (const OfPiece& piece : pieces)
        nodesOf.push_back(piece.nodes);
    const auto widen = [&](double factor) {
        spacing.edgePerDistance *= factor;
        spacing.least_m *= factor;
        spacing.longest_m *= factor;
    };
    // No farther apart than is needed for a few: their number falls as the square of that.
    double wider = std::clamp(
        std::sqrt(static_cast<double>(nodes()) / static_cast<double>(resolution.fewSenders)), 1.0,
        widest);
    widen(wider);
    while (!placeAll(pieces, *mesh_, spacing,
                     wider < 0.99 * widest                 ? resolution.fewSenders
                     : spacing.least_m < mesh_->extent_m() ? resolution.mostSenders
                                                           : allNodes)) {
        const double more = wider < 0.99 * widest ? std::min(step, widest / wider) : 1.3;
        widen(more);
        wider *= more;
    }
    senders_ = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        std::vector<std::uint32_t> number(pieces[p].nodes.size(), ExchangeMesh::none);
        for (std::uint32_t n = 0; n < nodesOf[p].size(); ++n) {
            std::uint32_t& sender = number[pieces[p].coveredBy[nodesOf[p][n]]];
            if (sender == ExchangeMesh::none)
                sender = static_cast<std::uint32_t>(senders_++);
            senderOf_[pieces[p].firstNode + n] = sender;
        }
    }
}

void ExchangeNodes::place(OfPiece& piece, const ExchangeMesh& mesh, const NodeSpacing& spacing,
                          std::size_t most, std::atomic<std::size_t>& outside) {
    const auto vertexAt = [&](std::size_t i) -> const ExchangeMesh::Vertex& {
        return mesh.vertices()[piece.first + i];
    };
    const auto sightAt = [&](std::size_t i) -> const ExchangeMesh::Sight& {
        return mesh.sights()[piece.first + i];
    };
    piece.apart_m.clear();
    piece.apart_m.reserve(piece.count);
    for (std::size_t i = 0; i < piece.count; ++i) {
        const double darkness =
            spacing.spareDark ? 1.0 / std::max(static_cast<double>(sightAt(i).open), 0.25) : 1.0;
        const double least_m = std::min(darkness * spacing.least_m, spacing.longest_m);
        piece.apart_m.push_back(std::clamp(
            spacing.edgePerDistance / std::sqrt(std::max(sightAt(i).nearness_per_m2, 1e-30)),
            least_m, spacing.longest_m));
    }
    piece.nodes.clear();
    constexpr auto nobody = std::numeric_limits<std::uint32_t>::max();
    piece.coveredBy.assign(piece.count, nobody);
    std::map<std::uint32_t, std::vector<std::size_t>> inside; // by space
    for (std::size_t i = 0; i < piece.count; ++i)
        if (vertexAt(i).space != 0)
            inside[vertexAt(i).space].push_back(i);
    // Surfaces smaller than what is between nodes are put together across gaps.
    const double small_m2 = smallSurface * spacing.least_m * spacing.least_m;
    const auto isSmall = [&](std::size_t i) {
        return vertexAt(i).space == 0 && piece.surface_m2[i] < small_m2;
    };
    Neighbourhood neighbourhood(spacing.least_m);
    for (std::size_t i = 0; i < piece.count; ++i)
        if (isSmall(i))
            neighbourhood.add(i, vertexAt(i).at_m);
    SurfaceWays ways(mesh, piece.first, piece.count);
    for (std::size_t i = 0; i < piece.count; ++i) {
        if (piece.coveredBy[i] != nobody)
            continue;
        const auto node = static_cast<std::uint32_t>(piece.nodes.size());
        piece.nodes.push_back(i);
        if (vertexAt(i).space != 0) {
            // What turns to a space inside is hardly ever seen: one node does.
            for (const std::size_t at : inside.at(vertexAt(i).space))
                piece.coveredBy[at] = node;
            continue;
        }
        if (++outside > most)
            return;
        const auto cover = [&](std::size_t at, double most_m, double distance_m) {
            if (piece.coveredBy[at] == nobody && distance_m < most_m &&
                dot(sightAt(i).normal, sightAt(at).normal) > alike)
                piece.coveredBy[at] = node;
        };
        ways.forEachAbout(i, piece.apart_m[i], [&](std::size_t at, double distance_m) {
            cover(at, piece.apart_m[at], distance_m);
        });
        if (isSmall(i))
            neighbourhood.forEachAbout(vertexAt(i).at_m, [&](std::size_t at) {
                cover(at, spacing.least_m, length(vertexAt(at).at_m - vertexAt(i).at_m));
            });
    }
}

void ExchangeNodes::share(OfPiece& piece, const ExchangeMesh& mesh) {
    std::vector<FewNodes>& found = piece.shares;
    found.assign(piece.count, {});
    SurfaceWays ways(mesh, piece.first, piece.count);
    for (std::uint32_t n = 0; n < piece.nodes.size(); ++n) {
        const std::size_t at = piece.nodes[n];
        const Vec3& normal = mesh.sights()[piece.first + at].normal;
        ways.forEachAbout(at, reach * piece.apart_m[at], [&](std::size_t i, double distance_m) {
            const double most_m = reach * std::min(piece.apart_m[i], piece.apart_m[at]);
            const double far = 1.0 - distance_m * distance_m / (most_m * most_m);
            const double turned = dot(normal, mesh.sights()[piece.first + i].normal) - notUnlike;
            if (i == at)
                found[i].offer(1.0 - notUnlike, n);
            else if (far > 0.0 && turned > 0.0)
                found[i].offer(far * far * turned, n);
        });
    }
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].count == 0)
            found[i].offer(1.0, piece.coveredBy[i]);
}

void ExchangeNodes::gatherPatches() {
    const std::size_t cells = mesh_->cells();
    std::vector<std::uint32_t> patchOf(cells);
    parallelFor(16, [&](std::size_t part) {
        std::vector<Share> sums;
        for (std::size_t t = beginOfPart(part, 16, cells); t < beginOfPart(part + 1, 16, cells);
             ++t) {
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
    cells_.resize(cells);
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < cells; ++t)
        cells_[next[patchOf[t]]++] = t;

    area_m2_.assign(nodes(), 0.0);
    areaUpTo_m2_.resize(cells);
    firstNear_.push_back(0);
    std::vector<double> own_m2(nodes(), -1.0); // by node: of the patch, below 0 where it has none
    std::vector<std::uint32_t> own;
    for (std::uint32_t patch = 0; patch < nodes(); ++patch) {
        own.clear();
        double sum_m2 = 0.0;
        for (std::uint32_t i = first_[patch]; i < first_[patch + 1]; ++i) {
            const double area_m2 = mesh_->area_m2(cells_[i]);
            areaUpTo_m2_[i] = sum_m2 += area_m2;
            for (const std::uint32_t corner : mesh_->corners(cells_[i]))
                for (const Share& one : sharesOf(corner)) {
                    if (own_m2[one.node] < 0.0) {
                        own_m2[one.node] = 0.0;
                        own.push_back(one.node);
                    }
                    own_m2[one.node] += static_cast<double>(one.part) * area_m2 / 3.0;
                }
        }
        std::ranges::sort(own);
        for (const std::uint32_t node : own) {
            area_m2_[node] += own_m2[node];
            near_.push_back({node, static_cast<float>(std::exchange(own_m2[node], -1.0))});
        }
        firstNear_.push_back(static_cast<std::uint32_t>(near_.size()));
    }
}

ExchangeNodes::OfPlace::OfPlace(const ExchangeNodes& nodes, const ExchangeMesh::Place& place) {
    static_assert(3 * mostShares == std::tuple_size_v<decltype(shares_)>);
    const auto& corners = nodes.mesh().corners(place.cell);
    const std::array<float, 3> parts{1.0f - place.u - place.v, place.u, place.v};
    for (std::size_t c = 0; c < 3; ++c)
        for (const Share& share : nodes.sharesOf(corners[c]))
            add(share.node, parts[c] * share.part);
}

ExchangeNodes::OfPlace ExchangeNodes::OfPlace::ofSenders(const ExchangeNodes& nodes) const {
    OfPlace senders;
    for (const Share& share : *this)
        senders.add(nodes.senderOf(share.node), share.part);
    return senders;
}

void ExchangeNodes::OfPlace::add(std::uint32_t number, float part) {
    const auto end = shares_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto known =
        std::find_if(shares_.begin(), end, [&](const Share& one) { return one.node == number; });
    if (known != end)
        known->part += part;
    else
        shares_[count_++] = {number, part};
}

std::size_t ExchangeNodes::placeNear(std::uint32_t patch, std::uint32_t node) const {
    const std::span<const Near> all = near(patch);
    return static_cast<std::size_t>(std::ranges::lower_bound(all, node, {}, &Near::node) -
                                    all.begin());
}

bool ExchangeNodes::seesAnything(std::uint32_t patch) const {
    return std::ranges::any_of(cellsOf(patch),
                               [&](std::uint32_t cell) { return mesh_->seesAnything(cell); });
}

ExchangeNodes::Start ExchangeNodes::start(std::uint32_t patch, double which, double a,
                                          double b) const {
    const auto begin = areaUpTo_m2_.begin() + first_[patch];
    const auto end = areaUpTo_m2_.begin() + first_[patch + 1] - 1;
    const auto found = std::upper_bound(begin, end, which * patchArea_m2(patch));
    const std::uint32_t cell = cells_[static_cast<std::size_t>(found - areaUpTo_m2_.begin())];
    const double root = std::sqrt(a);
    const double u = root * (1.0 - b), v = root * b;
    const std::array<Vec3, 3> c = mesh_->cornersAt_m(cell);
    Start start;
    start.place = {cell, static_cast<float>(u), static_cast<float>(v)};
    start.normal = mesh_->normal(cell);
    start.at_m = c[0] * (1.0 - u - v) + c[1] * u + c[2] * v + start.normal * mesh_->lift_m();
    return start;
}

} // namespace irsg
