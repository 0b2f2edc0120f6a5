#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include "irsg/core/ParallelFor.h"
#include "irsg/render/rays/RayMeshImpl.h"
#include "irsg/render/rays/RayVectors.h"

// What rays meet: the searches that Embree does for a mesh, and their filters.

namespace irsg {

namespace {

/// What Embree hands to the filter of a search.
struct Search {
    RTCIntersectContext context; // first: Embree knows no other part
    const PieceUse* uses = nullptr;
    std::vector<Candidate>* passed = nullptr;
    bool takesAll = false; ///< opaque facets do not end the search, either
};

/// How far a ray goes along the side of a facet whose corners are seen counter-clockwise from
/// there.
float towards(const RTCFilterFunctionNArguments& arguments) {
    RTCHitN* const hit = arguments.hit;
    RTCRayN* const ray = arguments.ray;
    return RTCHitN_Ng_x(hit, 1, 0) * RTCRayN_dir_x(ray, 1, 0) +
           RTCHitN_Ng_y(hit, 1, 0) * RTCRayN_dir_y(ray, 1, 0) +
           RTCHitN_Ng_z(hit, 1, 0) * RTCRayN_dir_z(ray, 1, 0);
}

void filterHits(const RTCFilterFunctionNArguments* arguments) {
    const auto& search = *reinterpret_cast<const Search*>(arguments->context);
    const unsigned piece = RTCHitN_geomID(arguments->hit, arguments->N, 0);
    const PieceUse& use = search.uses[piece];
    bool isTaken = use.isThere;
    if (isTaken && use.cullsBackFaces && !use.transparent)
        isTaken = towards(*arguments) < 0.0f;
    if (isTaken && (use.transparent || search.takesAll))
        search.passed->push_back({piece, RTCHitN_primID(arguments->hit, 1, 0)});
    if (!isTaken || use.transparent || search.takesAll)
        arguments->valid[0] = 0;
}

/// The same of a search for what takes light away.
struct LightSearch {
    RTCIntersectContext context; // first, likewise
    const PieceUse* uses = nullptr;
    const TracedPiece* pieces = nullptr;
    const TracedPiece* own = nullptr;  ///< of the facet that the light falls on, or none
    const unsigned* corners = nullptr; ///< of that facet
    std::vector<int>* through = nullptr;

    /// The facet itself, or one that continues it smoothly.
    bool isOwn(unsigned piece, unsigned facet) const {
        if (!own || pieces[piece].part != own->part)
            return false;
        const unsigned* others = &pieces[piece].triangles[3 * static_cast<std::size_t>(facet)];
        return std::any_of(corners, corners + 3, [&](unsigned corner) {
            return std::find(others, others + 3, corner) != others + 3;
        });
    }
};

void filterLight(const RTCFilterFunctionNArguments* arguments) {
    const auto& search = *reinterpret_cast<const LightSearch*>(arguments->context);
    const unsigned piece = RTCHitN_geomID(arguments->hit, arguments->N, 0);
    const unsigned facet = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const PieceUse& use = search.uses[piece];
    bool isTaken = use.isThere && !search.isOwn(piece, facet);
    if (isTaken && use.cullsBackFaces && !use.transparent)
        isTaken = towards(*arguments) > 0.0f; // its front is seen from the light
    if (isTaken && use.transparent)
        search.through->push_back(static_cast<int>(piece));
    if (!isTaken || use.transparent)
        arguments->valid[0] = 0;
}

/// The candidate is the nearest facet that ends a search.
std::optional<Candidate> searchIn(const RayMesh::Impl& impl, const Ray& ray, double from_m,
                                  double to_m, Search& search) {
    RTCRayHit found;
    found.ray = impl.rayFrom(ray, from_m, to_m);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl.scene, &search.context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    return Candidate{found.hit.geomID, found.hit.primID};
}

/// All facets that a ray meets between two distances along it, in any order.
void allBetween(const RayMesh::Impl& impl, const Ray& ray, double from_m, double to_m,
                std::vector<Candidate>& all) {
    thread_local std::vector<PieceUse> any;
    if (any.size() < impl.pieces.size())
        any.resize(impl.pieces.size(), {.isThere = true});
    all.clear();
    Search search;
    rtcInitIntersectContext(&search.context);
    search.context.filter = filterHits;
    search.uses = any.data();
    search.passed = &all;
    search.takesAll = true;
    searchIn(impl, ray, from_m, to_m, search);
}

/// Of the angle between a facet and a ray, for how far a subface is lifted.
constexpr double leastCosine = 0.05;

/// How far a facet is lifted towards the eye: by as much as its depth changes over a sample, and by
/// rounding, for each layer.
double lift_m(const Ray& ray, const RayHit& hit, int layer, const Vec3& plane, double sampleWidth,
              double rounding_m) {
    if (layer == 0)
        return 0.0;
    const double cosine = std::max(std::abs(dot(plane, ray.direction)), leastCosine);
    const double slope = std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) / cosine;
    return layer * (sampleWidth * hit.distance_m * slope + 4.0 * rounding_m / cosine);
}

double mostLift_m(const RayHit& hit, int layers, double sampleWidth, double rounding_m) {
    return layers * (sampleWidth * hit.distance_m + 4.0 * rounding_m) / leastCosine;
}

} // namespace

bool RayMesh::meet(const Ray& ray, const PieceUses& uses, double sampleWidth, RayHit& opaque,
                   std::vector<RayHit>& through) const {
    through.clear();
    double from_m = 0.0, to_m = 0.0;
    if (impl_->facets == 0 || !impl_->clip(ray, from_m, to_m))
        return false;
    thread_local std::vector<Candidate> passed;
    passed.clear();
    Search search;
    rtcInitIntersectContext(&search.context);
    search.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    search.uses = uses.data();
    search.passed = &passed;
    if (!uses.arePlain())
        search.context.filter = filterHits;
    const std::optional<Candidate> nearest = searchIn(*impl_, ray, from_m, to_m, search);
    if (nearest)
        opaque = impl_->refined(ray, *nearest);
    if (uses.layers() == 0) {
        for (const Candidate& candidate : passed) {
            const RayHit hit = impl_->refined(ray, candidate);
            if (!nearest || hit.distance_m < opaque.distance_m)
                through.push_back(hit);
        }
        return nearest.has_value();
    }

    // What lies in the plane of the nearest, or almost, may stand on it.
    if (nearest)
        to_m = std::min(to_m, opaque.distance_m + mostLift_m(opaque, uses.layers(), sampleWidth,
                                                             impl_->rounding_m));
    passed.clear();
    search.takesAll = true;
    search.context.filter = filterHits;
    searchIn(*impl_, ray, from_m, to_m, search);
    std::vector<RayHit> hits;
    for (const Candidate& candidate : passed) {
        RayHit& hit = hits.emplace_back(impl_->refined(ray, candidate));
        hit.order_m -= lift_m(ray, hit, uses[candidate.piece].layer, planeNormal(hit), sampleWidth,
                              impl_->rounding_m);
    }
    const auto isTransparent = [&](const RayHit& hit) {
        return uses[static_cast<std::size_t>(hit.piece)].transparent;
    };
    bool isMet = false;
    for (const RayHit& hit : hits)
        if (!isTransparent(hit) && (!isMet || hit.order_m < opaque.order_m)) {
            opaque = hit;
            isMet = true;
        }
    for (const RayHit& hit : hits)
        if (isTransparent(hit) && (!isMet || hit.order_m < opaque.order_m))
            through.push_back(hit);
    return isMet;
}

std::optional<RayHit> RayMesh::seenAt(const Ray& ray, const Distance& distance,
                                      const PieceUses& uses,
                                      const std::function<bool(int)>& isWanted) const {
    Ray part = ray;
    part.from_m = std::max(distance.m - distance.off_m - impl_->rounding_m, 0.0);
    part.to_m = distance.m + distance.off_m + impl_->rounding_m;
    double from_m = 0.0, to_m = 0.0;
    if (impl_->facets == 0 || !impl_->clip(part, from_m, to_m))
        return std::nullopt;
    thread_local std::vector<Candidate> passed;
    allBetween(*impl_, part, from_m, to_m, passed);
    // Lower is better: of what rounding does not tell apart by layers and how far, then others.
    const auto rankOf = [&](const RayHit& hit) {
        const double off_m = std::abs(hit.distance_m - distance.m);
        return off_m <= distance.rounding_m
                   ? std::tuple(0, -uses[static_cast<std::size_t>(hit.piece)].layer, hit.distance_m)
                   : std::tuple(1, 0, off_m);
    };
    std::optional<RayHit> best;
    for (const Candidate& candidate : passed) {
        if (!isWanted(static_cast<int>(candidate.piece)))
            continue;
        const RayHit hit = impl_->refined(ray, candidate);
        if (!uses.isCulled(hit) && (!best || rankOf(hit) < rankOf(*best)))
            best = hit;
    }
    return best;
}

double RayMesh::Impl::closeSheets_m() const {
    constexpr double ofSize = 1e-3;
    return ofSize * plainLength({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

void RayMesh::Impl::findCloseSheets() {
    std::vector<std::size_t> firstOf; // by piece
    for (const TracedPiece& piece : pieces) {
        firstOf.push_back(firstOf.empty() ? 0 : firstOf.back() + hasCloseSheet.back().size());
        hasCloseSheet.emplace_back(piece.triangles.size() / 3);
    }
    const auto candidateOf = [&](std::size_t number) {
        const auto behind = std::ranges::upper_bound(firstOf, number);
        const auto own = static_cast<std::size_t>(behind - firstOf.begin()) - 1;
        return Candidate{static_cast<unsigned>(own), static_cast<unsigned>(number - firstOf[own])};
    };
    const double reach_m = closeSheets_m();
    constexpr std::size_t parts = 64;
    std::vector<std::vector<Candidate>> close(parts);
    parallelFor(parts, [&](std::size_t part) {
        std::vector<Candidate> passed;
        for (std::size_t i = beginOfPart(part, parts, facets);
             i < beginOfPart(part + 1, parts, facets); ++i) {
            const Candidate own = candidateOf(i);
            const TracedPiece& piece = pieces[own.piece];
            const unsigned* corner = &piece.triangles[3 * static_cast<std::size_t>(own.facet)];
            const Vec3 a = piece.vertex(corner[0]), b = piece.vertex(corner[1]),
                       c = piece.vertex(corner[2]);
            const Vec3 across = crossed(b - a, c - a);
            const double size = plainLength(across);
            if (!(size > 0.0))
                continue;
            const Vec3 normal = across * (1.0 / size);
            const Ray through{(a + b + c) * (1.0 / 3.0) - normal * reach_m, normal, 0.0,
                              2.0 * reach_m};
            double from_m = 0.0, to_m = 0.0;
            if (!clip(through, from_m, to_m))
                continue;
            allBetween(*this, through, from_m, to_m, passed);
            const auto isOther = [&](const Candidate& one) {
                return one.piece != own.piece || one.facet != own.facet;
            };
            if (std::ranges::none_of(passed, isOther))
                continue;
            // The other may be wider, and not meet one through its own middle.
            close[part].push_back(own);
            std::ranges::copy_if(passed, std::back_inserter(close[part]), isOther);
        }
    });
    for (const std::vector<Candidate>& some : close)
        for (const Candidate& one : some)
            hasCloseSheet[one.piece][one.facet] = 1;
}

void RayMesh::findCloseSheets() const {
    std::call_once(impl_->closeSheetsFound, [&] { impl_->findCloseSheets(); });
}

bool RayMesh::standsAlone(int piece, unsigned facet, double apart_m) const {
    return apart_m <= impl_->closeSheets_m() &&
           impl_->hasCloseSheet[static_cast<std::size_t>(piece)][facet] == 0;
}

bool RayMesh::letsPass(const Ray& ray, const PieceUses& uses, const RayHit* own,
                       std::vector<int>& through) const {
    double from_m = 0.0, to_m = 0.0;
    if (impl_->facets == 0 || !impl_->clip(ray, from_m, to_m))
        return true;
    LightSearch search;
    rtcInitIntersectContext(&search.context);
    search.context.filter = filterLight;
    search.uses = uses.data();
    search.pieces = impl_->pieces.data();
    search.through = &through;
    if (own) {
        search.own = &impl_->pieces[static_cast<std::size_t>(own->piece)];
        search.corners = &search.own->triangles[3 * static_cast<std::size_t>(own->facet)];
    }
    RTCRay along = impl_->rayFrom(ray, from_m, to_m);
    rtcOccluded1(impl_->scene, &search.context, &along);
    return along.tfar >= 0.0f; // Embree sets it below where something is met
}

} // namespace irsg
