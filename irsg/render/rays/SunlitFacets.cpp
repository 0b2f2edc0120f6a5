#include "irsg/render/rays/SunlitFacets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// Least sine of the height of a source over a facet of which anything is said.
constexpr double leastHeight = 1e-6;
/// Facets that lie in more cells than this stand in a list of their own.
constexpr std::size_t manyCells = 64;
constexpr std::size_t mostCells = 512; // along an axis

/// By how much two triangles are apart along the normals of the edges of the first, at most.
double gapAlongEdges(const std::array<double, 3>& ax, const std::array<double, 3>& ay,
                     const std::array<double, 3>& bx, const std::array<double, 3>& by) {
    double widest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
        double nx = ay[next] - ay[i], ny = ax[i] - ax[next];
        const double size = std::hypot(nx, ny);
        if (size < 1e-12)
            continue;
        // Away from the triangle's own third corner.
        const double inwards = (ax[last] - ax[i]) * nx + (ay[last] - ay[i]) * ny;
        const double per = (inwards > 0.0 ? -1.0 : 1.0) / size;
        nx *= per;
        ny *= per;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k)
            nearest = std::min(nearest, (bx[k] - ax[i]) * nx + (by[k] - ay[i]) * ny);
        widest = std::max(widest, nearest);
    }
    return widest;
}

} // namespace

double SunlitFacets::Outline::least(const std::array<double, 3>& of) const {
    return std::min({of[0], of[1], of[2]});
}
double SunlitFacets::Outline::most(const std::array<double, 3>& of) const {
    return std::max({of[0], of[1], of[2]});
}

SunlitFacets::Outline SunlitFacets::outlineOf(const std::array<Vec3, 3>& corners_m) const {
    Outline outline;
    for (std::size_t i = 0; i < 3; ++i) {
        outline.x[i] = dot(corners_m[i], right_);
        outline.y[i] = dot(corners_m[i], up_);
        outline.along[i] = dot(corners_m[i], towards_);
    }
    return outline;
}

SunlitFacets::SunlitFacets(const std::shared_ptr<const RayMesh>& mesh, PieceUses uses,
                           const Vec3& towards, double radius_rad)
    : of_(mesh),
      mesh_(mesh.get()),
      uses_(std::move(uses)),
      towards_(towards),
      radius_rad_(radius_rad),
      rounding_m_(mesh_->rounding_m()) {
    std::tie(right_, up_) = acrossTo(towards);
    constexpr float far = std::numeric_limits<float>::infinity();
    all_ = {far, -far, far, -far, -far};
    const auto below = [](double value) { return std::nextafter(static_cast<float>(value), -far); };
    const auto above = [](double value) { return std::nextafter(static_cast<float>(value), far); };
    for (std::size_t piece = 0; piece < mesh_->pieces(); ++piece) {
        firstFacet_.push_back(static_cast<std::uint32_t>(boxes_.size()));
        for (unsigned f = 0; f < mesh_->facetsOf(piece); ++f) {
            const Outline o = outlineOf(mesh_->facet(piece, f).corners_m);
            const Box& box = boxes_.emplace_back(Box{below(o.least(o.x)), above(o.most(o.x)),
                                                     below(o.least(o.y)), above(o.most(o.y)),
                                                     above(o.most(o.along))});
            pieceOf_.push_back(static_cast<std::uint32_t>(piece));
            all_ = {std::min(all_.x0, box.x0), std::max(all_.x1, box.x1), std::min(all_.y0, box.y0),
                    std::max(all_.y1, box.y1), std::max(all_.along, box.along)};
        }
    }
    const std::size_t facets = boxes_.size();
    known_ = std::make_unique<std::atomic<std::uint8_t>[]>(2 * facets);
    side_ = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::sqrt(static_cast<double>(facets))), 1, mostCells);
    const auto cellsOf = [&](const Box& box) {
        std::size_t cells = 0;
        forEachCell(box, [&](std::size_t) { ++cells; });
        return cells;
    };
    std::vector<bool> isLarge(facets);
    begin_.assign(side_ * side_ + 1, 0);
    for (std::size_t i = 0; i < facets; ++i) {
        isLarge[i] = cellsOf(boxes_[i]) > manyCells;
        if (isLarge[i])
            large_.push_back(static_cast<std::uint32_t>(i));
        else
            forEachCell(boxes_[i], [&](std::size_t cell) { ++begin_[cell + 1]; });
    }
    for (std::size_t cell = 0; cell < side_ * side_; ++cell)
        begin_[cell + 1] += begin_[cell];
    in_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < facets; ++i)
        if (!isLarge[i])
            forEachCell(boxes_[i], [&](std::size_t cell) {
                in_[next[cell]++] = static_cast<std::uint32_t>(i);
            });
}

bool SunlitFacets::isOf(const std::shared_ptr<const RayMesh>& mesh, const PieceUses& uses,
                        const Vec3& towards, double radius_rad) const {
    // As directions are turned there and back.
    constexpr double rounding = 1e-12;
    const Vec3 apart = towards - towards_;
    return mesh == of_.lock() && dot(apart, apart) <= rounding * rounding &&
           radius_rad == radius_rad_ && uses == uses_;
}

std::size_t SunlitFacets::cellOf(float place, float low, float size) const {
    const float cells = static_cast<float>(side_);
    const float cell = size > 0.0f ? (place - low) / size * cells : 0.0f;
    return static_cast<std::size_t>(std::clamp(cell, 0.0f, cells - 1.0f));
}

template <typename Visit>
void SunlitFacets::forEachCell(const Box& box, Visit visit) const {
    const std::size_t x1 = cellOf(box.x1, all_.x0, all_.x1 - all_.x0),
                      y1 = cellOf(box.y1, all_.y0, all_.y1 - all_.y0);
    for (std::size_t y = cellOf(box.y0, all_.y0, all_.y1 - all_.y0); y <= y1; ++y)
        for (std::size_t x = cellOf(box.x0, all_.x0, all_.x1 - all_.x0); x <= x1; ++x)
            visit(y * side_ + x);
}

bool SunlitFacets::isLit(const RayHit& hit) const {
    const std::size_t facet = firstFacet_[static_cast<std::size_t>(hit.piece)] + hit.facet;
    std::atomic<std::uint8_t>& known = known_[2 * facet + (hit.isFront ? 0 : 1)];
    std::uint8_t state = known.load(std::memory_order_relaxed);
    if (state == unknown) {
        state = isFree(facet, hit.isFront) ? lit : unsure;
        known.store(state, std::memory_order_relaxed);
    }
    return state == lit;
}

bool SunlitFacets::mayStandOver(std::size_t other, std::size_t facet, const RayMesh::Facet& own,
                                const Outline& outline, const Vec3& normal, double bulge_m) const {
    const std::uint32_t piece = pieceOf_[other];
    const PieceUse& use = uses_[piece];
    if (other == facet || !use.isThere)
        return false;
    const double lowest_m = outline.least(outline.along) - bulge_m;
    const double over_m = static_cast<double>(boxes_[other].along) - lowest_m;
    if (over_m <= 0.0)
        return false;
    const RayMesh::Facet found =
        mesh_->facet(piece, static_cast<unsigned>(other) - firstFacet_[piece]);
    const auto& c = found.corners_m;
    const double height_m =
        std::max({dot(c[0] - own.corners_m[0], normal), dot(c[1] - own.corners_m[0], normal),
                  dot(c[2] - own.corners_m[0], normal)});
    if (height_m <= rounding_m_)
        return false;
    // One smooth surface with it: as rays have it.
    if (found.arrays == own.arrays && std::ranges::any_of(found.vertices, [&](unsigned vertex) {
            return std::ranges::find(own.vertices, vertex) != own.vertices.end();
        }))
        return false;
    if (use.cullsBackFaces && !use.transparent) {
        const Vec3 across = cross(c[1] - c[0], c[2] - c[0]);
        if (dot(across, towards_) < -(std::sin(radius_rad_) + leastHeight) * length(across))
            return false; // only its back is seen from there
    }
    // What touches it hides nothing of it.
    const double needed_m = (bulge_m > 0.0 ? bulge_m + rounding_m_ : -0.25 * rounding_m_) +
                            over_m * std::tan(radius_rad_);
    const Outline theirs = outlineOf(c);
    return gapAlongEdges(outline.x, outline.y, theirs.x, theirs.y) < needed_m &&
           gapAlongEdges(theirs.x, theirs.y, outline.x, outline.y) < needed_m;
}

bool SunlitFacets::isFree(std::size_t facet, bool isFront) const {
    const std::uint32_t piece = pieceOf_[facet];
    const auto number = static_cast<unsigned>(facet) - firstFacet_[piece];
    const RayMesh::Facet own = mesh_->facet(piece, number);
    const auto& c = own.corners_m;
    const Vec3 across = cross(c[1] - c[0], c[2] - c[0]) * (isFront ? 1.0 : -1.0);
    if (across == Vec3{})
        return false;
    const Vec3 normal = normalized(across);
    if (dot(normal, towards_) < std::sin(radius_rad_) + leastHeight)
        return false;
    // How far from the facet rays may start.
    const double bulge_m = mesh_->bulge_m(piece, number, isFront);
    if (!(bulge_m >= 0.0))
        return false;
    const Outline outline = outlineOf(c);
    const double margin_m =
        bulge_m + rounding_m_ +
        std::max(static_cast<double>(all_.along) - outline.least(outline.along) + bulge_m, 0.0) *
            std::tan(radius_rad_);
    const Box& tight = boxes_[facet];
    const auto margin = static_cast<float>(margin_m);
    const Box box{tight.x0 - margin, tight.x1 + margin, tight.y0 - margin, tight.y1 + margin,
                  tight.along};
    const auto hides = [&](std::uint32_t other) {
        const Box& theirs = boxes_[other];
        return theirs.x0 <= box.x1 && theirs.x1 >= box.x0 && theirs.y0 <= box.y1 &&
               theirs.y1 >= box.y0 && mayStandOver(other, facet, own, outline, normal, bulge_m);
    };
    if (std::ranges::any_of(large_, hides))
        return false;
    bool isHidden = false;
    forEachCell(box, [&](std::size_t cell) {
        for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1] && !isHidden; ++i)
            isHidden = hides(in_[i]);
    });
    return !isHidden;
}

} // namespace irsg
