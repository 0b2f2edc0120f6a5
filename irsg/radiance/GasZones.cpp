#include "irsg/radiance/GasZones.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/JoinedNumbers.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/GasCrossing.h"

namespace irsg {

namespace {

template <typename Visit>
void forEachFacet(const Mesh& mesh, const IrCodes& codes, Visit visit) {
    for (const Mesh::Part& part : mesh.parts)
        for (std::size_t i = 0; part.codes == codes && i + 2 < part.triangles.size(); i += 3)
            visit(std::array{part.vertices[part.triangles[i]], part.vertices[part.triangles[i + 1]],
                             part.vertices[part.triangles[i + 2]]});
}

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
    return dot(a, cross(b, c));
}

/// Numbers for places, the same for those that rounding alone sets apart.
class PlaceNumbers {
  public:
    explicit PlaceNumbers(double apart_m) : apart_m_(apart_m) {}

    int of(const Vec3& place_m) {
        const Cell own = cellOf(place_m);
        for (long x = own[0] - 1; x <= own[0] + 1; ++x)
            for (long y = own[1] - 1; y <= own[1] + 1; ++y)
                for (long z = own[2] - 1; z <= own[2] + 1; ++z)
                    if (const auto found = cells_.find({x, y, z}); found != cells_.end())
                        for (const int number : found->second)
                            if (length(places_m_[static_cast<std::size_t>(number)] - place_m) <=
                                apart_m_)
                                return number;
        cells_[own].push_back(static_cast<int>(places_m_.size()));
        places_m_.push_back(place_m);
        return static_cast<int>(places_m_.size()) - 1;
    }

  private:
    using Cell = std::array<long, 3>;
    Cell cellOf(const Vec3& place_m) const {
        return {std::lround(place_m.x / apart_m_), std::lround(place_m.y / apart_m_),
                std::lround(place_m.z / apart_m_)};
    }

    double apart_m_;
    std::vector<Vec3> places_m_;
    std::map<Cell, std::vector<int>> cells_;
};

constexpr double rounding = 1e-6; // of the size

GasZoneShape shapeOf(const Mesh& mesh, const IrCodes& codes) {
    GasZoneShape shape;
    BoundingBox box = BoundingBox::nowhere();
    double six_m3 = 0.0, radius_m = 0.0;
    std::map<std::pair<int, int>, int> edges; // how often in one sense less in the other
    for (const Mesh::Part& part : mesh.parts)
        if (part.codes == codes)
            box.include(part.bounds);
    if (!box.valid())
        return shape;
    const Vec3 centre = box.centre();
    PlaceNumbers numbers(std::max(rounding * box.diagonal_m(), 1e-12));
    forEachFacet(mesh, codes, [&](const std::array<Float3, 3>& facet) {
        six_m3 += determinant(toVec3(facet[0]) - centre, toVec3(facet[1]) - centre,
                              toVec3(facet[2]) - centre);
        std::array<int, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            radius_m = std::max(radius_m, length(toVec3(facet[k]) - centre));
            corners[k] = numbers.of(toVec3(facet[k]) - centre);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = corners[k], to = corners[(k + 1) % 3];
            if (from != to)
                edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    });
    shape.volume_m3 = std::abs(six_m3) / 6.0;
    shape.longest_m = 2.0 * radius_m;
    shape.openEdges = static_cast<int>(
        std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
    return shape;
}

using Facets = std::vector<std::array<Vec3, 3>>;

Facets facetsOf(const Mesh& mesh, const IrCodes& codes) {
    Facets facets;
    forEachFacet(mesh, codes, [&](const std::array<Float3, 3>& facet) {
        facets.push_back({toVec3(facet[0]), toVec3(facet[1]), toVec3(facet[2])});
    });
    return facets;
}

/// Half the solid angle of facets as seen from a place: 2 pi inside, 0 outside (A. Van Oosterom
/// and J. Strackee 1983, IEEE Trans. Biomed. Eng. 30, 125).
double halfAngleOf_sr(const Facets& facets, const Vec3& place_m) {
    double half_sr = 0.0;
    for (const std::array<Vec3, 3>& facet : facets) {
        const Vec3 a = facet[0] - place_m, b = facet[1] - place_m, c = facet[2] - place_m;
        const double la = length(a), lb = length(b), lc = length(c);
        half_sr += std::atan2(determinant(a, b, c),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return half_sr;
}

/// Where corners of one lie about the other; those on its walls count for neither.
struct Corners {
    bool areIn = false, areOut = false;
};
Corners cornersOf(const Facets& one, const Facets& other) {
    constexpr std::size_t looks = 32;
    constexpr double clear = 0.1; // of the angle: nearer to a wall is on it
    Corners corners;
    const std::size_t step = std::max<std::size_t>(one.size() / looks, 1);
    for (std::size_t i = 0; i < one.size() && !(corners.areIn && corners.areOut); i += step) {
        const double part = std::abs(halfAngleOf_sr(other, one[i][0])) / (2.0 * std::numbers::pi);
        corners.areIn = corners.areIn || part > 1.0 - clear;
        corners.areOut = corners.areOut || part < clear;
    }
    return corners;
}

/// Above 0 where the facets look outwards.
double signedVolume_m3(const Facets& facets) {
    double six_m3 = 0.0;
    const Vec3 from = facets.front()[0];
    for (const std::array<Vec3, 3>& facet : facets)
        six_m3 += determinant(facet[0] - from, facet[1] - from, facet[2] - from);
    return six_m3 / 6.0;
}

BoundingBox boxOf(const Facets& facets) {
    BoundingBox box = BoundingBox::nowhere();
    for (const std::array<Vec3, 3>& facet : facets)
        for (const Vec3& corner : facet)
            box.include(corner);
    return box;
}

bool meet(const BoundingBox& one, const BoundingBox& other) {
    return one.min.x <= other.max.x && other.min.x <= one.max.x && one.min.y <= other.max.y &&
           other.min.y <= one.max.y && one.min.z <= other.max.z && other.min.z <= one.max.z;
}

/// Facets that corners join.
std::vector<Facets> apartOf(const Facets& facets) {
    if (facets.empty())
        return {};
    const BoundingBox box = boxOf(facets);
    PlaceNumbers numbers(std::max(rounding * box.diagonal_m(), 1e-12));
    JoinedNumbers joined(3 * facets.size());
    std::vector<std::uint32_t> firstCorners;
    for (const std::array<Vec3, 3>& facet : facets) {
        const auto cornerOf = [&](std::size_t k) {
            return static_cast<std::uint32_t>(numbers.of(facet[k]));
        };
        firstCorners.push_back(cornerOf(0));
        joined.join(cornerOf(1), cornerOf(0));
        joined.join(cornerOf(2), cornerOf(0));
    }
    std::map<std::uint32_t, Facets> byCorner;
    for (std::size_t i = 0; i < facets.size(); ++i)
        byCorner[joined.of(firstCorners[i])].push_back(facets[i]);
    std::vector<Facets> apart;
    apart.reserve(byCorner.size());
    for (auto& [corner, own] : byCorner)
        apart.push_back(std::move(own));
    return apart;
}

bool doCross(const Mesh& mesh, const IrCodes& one, const IrCodes& other) {
    if (one != other) {
        const Corners corners = cornersOf(facetsOf(mesh, one), facetsOf(mesh, other));
        return corners.areIn && corners.areOut;
    }
    // Of one gas those that hold each other are no better, but for a hollow, which looks inwards.
    const std::vector<Facets> apart = apartOf(facetsOf(mesh, one));
    std::vector<BoundingBox> boxes;
    boxes.reserve(apart.size());
    for (const Facets& own : apart)
        boxes.push_back(boxOf(own));
    for (std::size_t i = 0; i < apart.size(); ++i)
        for (std::size_t k = 0; k < apart.size(); ++k) {
            if (i == k || !meet(boxes[i], boxes[k]))
                continue;
            const Corners corners = cornersOf(apart[i], apart[k]);
            if (corners.areIn && (corners.areOut || (signedVolume_m3(apart[i]) > 0.0) ==
                                                        (signedVolume_m3(apart[k]) > 0.0)))
                return true;
        }
    return false;
}

struct KnownCrossing {
    std::weak_ptr<const Mesh> mesh;
    IrCodes one, other;
    bool cross = false;
};

struct KnownShape {
    std::weak_ptr<const Mesh> mesh;
    IrCodes codes;
    GasZoneShape shape;
};

struct KnownColumns {
    std::mutex mutex;
    std::unordered_map<int, GasColumnKey> byNumber; // whose entries stay where they are
};
KnownColumns& knownColumns() {
    static KnownColumns known;
    return known;
}

/// FNV-1a over the column's numbers.
std::uint32_t hashOf(const GasColumnKey& column) {
    std::uint64_t hash = 14695981039346656037ull;
    const auto take = [&](std::uint64_t word) {
        for (int byte = 0; byte < 8; ++byte, word >>= 8)
            hash = (hash ^ (word & 0xff)) * 1099511628211ull;
    };
    take(column.before);
    for (const GasColumnKey::Stretch& stretch : column.stretches) {
        take(static_cast<std::uint64_t>(stretch.codes.temperature));
        take(static_cast<std::uint64_t>(stretch.codes.material));
        take(std::bit_cast<std::uint64_t>(stretch.length_m));
    }
    return static_cast<std::uint32_t>(hash ^ (hash >> 32));
}

} // namespace

GasZoneShape gasZoneShape(const std::shared_ptr<const Mesh>& mesh, const IrCodes& codes) {
    static std::mutex mutex;
    static RecentlyUsed<KnownShape> known{256};
    const std::lock_guard lock(mutex);
    const auto isIt = [&](const KnownShape& one) {
        return one.codes == codes && one.mesh.lock() == mesh;
    };
    if (const KnownShape* found = known.find(isIt))
        return found->shape;
    return known.add({mesh, codes, shapeOf(*mesh, codes)}).shape;
}

bool isInGasZone(const Mesh& mesh, const IrCodes& codes, const Vec3& place_m) {
    return std::abs(halfAngleOf_sr(facetsOf(mesh, codes), place_m)) > std::numbers::pi;
}

bool doGasZonesCross(const std::shared_ptr<const Mesh>& mesh, const IrCodes& one,
                     const IrCodes& other) {
    static std::mutex mutex;
    static RecentlyUsed<KnownCrossing> known{1024};
    const std::lock_guard lock(mutex);
    const auto isIt = [&](const KnownCrossing& of) {
        return of.one == one && of.other == other && of.mesh.lock() == mesh;
    };
    if (const KnownCrossing* found = known.find(isIt))
        return found->cross;
    return known.add({mesh, one, other, doCross(*mesh, one, other)}).cross;
}

int gasColumnNumber(const GasColumnKey& column) {
    KnownColumns& known = knownColumns();
    constexpr std::uint32_t numbers = (1u << 30) - 1;
    std::uint32_t place = hashOf(column) % numbers;
    const std::lock_guard lock(known.mutex);
    while (true) {
        const int number = -(1 << 30) - 1 - static_cast<int>(place);
        const auto [found, isNew] = known.byNumber.try_emplace(number, column);
        if (isNew || found->second == column)
            return number;
        place = (place + 1) % numbers;
    }
}

const GasColumnKey& gasColumn(int number) {
    KnownColumns& known = knownColumns();
    const std::lock_guard lock(known.mutex);
    const auto found = known.byNumber.find(number);
    if (found == known.byNumber.end())
        throw LogicError("a column of gas was asked for that nobody has met");
    return found->second;
}

const OccluderMaterial* gasColumnOf(const std::vector<OccluderMaterial>& materials, int entity) {
    const auto found = std::ranges::find_if(materials, [&](const OccluderMaterial& material) {
        return material.first == entity && isGasColumn(material.second);
    });
    return found == materials.end() ? nullptr : &*found;
}

} // namespace irsg
