#include "irsg/geometry/model/FaceMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include <osg/Drawable>
#include <osg/Material>
#include <osg/Node>

#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/conversion/PaintedGrid.h"
#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/PolygonPlace.h"

namespace irsg {
namespace {

constexpr double sameOfDiagonal = 1e-6;
/// Edges with more faces than that are none of a surface: their faces are joined in a chain.
constexpr std::size_t mostAtAnEdge = 16;

/// Numbers for places, the same for those that lie within a tolerance.
class Places {
  public:
    Places(const Vec3& low, double tolerance)
        : low_(low), tolerance_(tolerance), cell_(4.0 * tolerance) {}

    unsigned int numberOf(const Vec3& place) {
        const auto at = cellOf(place);
        if (const int known = knownIn(at, place); known >= 0)
            return static_cast<unsigned int>(known);
        // Beside the border of a cell the others that touch it may have it.
        const Vec3 around = Vec3{1, 1, 1} * tolerance_;
        const auto lower = cellOf(place - around), upper = cellOf(place + around);
        if (lower != upper)
            for (auto x = lower[0]; x <= upper[0]; ++x)
                for (auto y = lower[1]; y <= upper[1]; ++y)
                    for (auto z = lower[2]; z <= upper[2]; ++z)
                        if (const int known = knownIn({x, y, z}, place); known >= 0)
                            return static_cast<unsigned int>(known);
        const auto number = static_cast<unsigned int>(places_.size());
        const auto [cell, isFirst] = cells_.try_emplace(keyOf(at), static_cast<int>(number));
        places_.push_back({place, isFirst ? -1 : cell->second});
        cell->second = static_cast<int>(number);
        return number;
    }

  private:
    using Cell = std::array<long, 3>;
    struct Kept {
        Vec3 place;
        int next = -1; ///< in the same cell
    };
    Cell cellOf(const Vec3& place) const {
        const Vec3 from = place - low_;
        return {std::lround(std::floor(from.x / cell_)), std::lround(std::floor(from.y / cell_)),
                std::lround(std::floor(from.z / cell_))};
    }
    /// Cells of one key are told apart by the places in them.
    static std::uint64_t keyOf(const Cell& cell) {
        std::uint64_t key = 0;
        for (const long part : cell)
            key = key * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(part);
        return key ^ (key >> 29);
    }
    int knownIn(const Cell& cell, const Vec3& place) const {
        const auto found = cells_.find(keyOf(cell));
        for (int i = found == cells_.end() ? -1 : found->second; i >= 0;
             i = places_[static_cast<std::size_t>(i)].next)
            if (const Vec3 off = places_[static_cast<std::size_t>(i)].place - place;
                dot(off, off) <= tolerance_ * tolerance_)
                return i;
        return -1;
    }

    Vec3 low_;
    double tolerance_, cell_;
    std::vector<Kept> places_;
    std::unordered_map<std::uint64_t, int> cells_; ///< the last place of each
};

/// Which of many hang together.
class Together {
  public:
    explicit Together(std::size_t count) : above_(count) {
        std::iota(above_.begin(), above_.end(), 0U);
    }
    unsigned int rootOf(unsigned int one) {
        while (above_[one] != one)
            one = above_[one] = above_[above_[one]];
        return one;
    }
    void join(unsigned int one, unsigned int other) { above_[rootOf(one)] = rootOf(other); }

  private:
    std::vector<unsigned int> above_;
};

/// Numbers for materials: by name, and without one by the state that has them.
class Materials {
  public:
    unsigned int numberOf(const std::string& name, const osg::Drawable& drawable,
                          const std::vector<osg::Node*>& path) {
        const void* state = name.empty() ? materialState(drawable, path) : nullptr;
        return known_.try_emplace({name, state}, static_cast<unsigned int>(known_.size()))
            .first->second;
    }

  private:
    static const void* materialState(const osg::Drawable& drawable,
                                     const std::vector<osg::Node*>& path) {
        const auto has = [](const osg::StateSet* state) {
            return state && state->getAttribute(osg::StateAttribute::MATERIAL);
        };
        if (has(drawable.getStateSet()))
            return drawable.getStateSet()->getAttribute(osg::StateAttribute::MATERIAL);
        for (auto node = path.rbegin(); node != path.rend(); ++node)
            if (has((*node)->getStateSet()))
                return (*node)->getStateSet()->getAttribute(osg::StateAttribute::MATERIAL);
        return nullptr;
    }
    std::map<std::pair<std::string, const void*>, unsigned int> known_;
};

} // namespace

FaceMesh::FaceMesh(const LoadedGraph& graph, const std::vector<CodeRule>& rules,
                   const std::string& name) {
    SurfaceMesh none;
    GeometryCollector collector(none, {}, name, {});
    Materials materials;
    bool isNew = false;
    Face face;
    collector.giveTo([&](const DrawnPolygon& polygon) {
        isNew = isNew || polygon.first;
        const PolygonPlace place = placeOf(polygon.corners);
        if (place.cut.triangles.empty())
            return;
        // Polygons of a drawable come in a row; one at several places has other names at each.
        if (isNew) {
            isNew = false;
            face.codes = polygon.kind.codes;
            const FaceNames names = namesOver(polygon.drawable, polygon.path);
            for (const CodeRule& rule : rules)
                if (fits(rule, names))
                    face.codes = rule.codes.over(face.codes);
            face.material = materials.numberOf(names.material, polygon.drawable, polygon.path);
        }
        face.culled = polygon.kind.culled;
        face.turned = polygon.turned;
        face.point = fromOsg(place.point);
        face.normal = fromOsg(place.normal);
        face.area = place.area;
        face.first = static_cast<unsigned int>(triangles_.size());
        face.count = static_cast<unsigned int>(place.cut.triangles.size());
        for (const auto& [a, b, c] : place.cut.triangles)
            triangles_.push_back({fromOsg(polygon.corners[a].position),
                                  fromOsg(polygon.corners[b].position),
                                  fromOsg(polygon.corners[c].position)});
        faces_.push_back(face);
    });
    collector.collect(*graph.node);
    join();
}

void FaceMesh::join() {
    BoundingBox bounds = BoundingBox::nowhere();
    for (const Triangle& triangle : triangles_)
        for (const Vec3& corner : triangle)
            bounds.include(corner);
    if (!triangles_.empty())
        diagonal_ = bounds.diagonal_m();
    Places places(bounds.min, std::max(sameOfDiagonal * diagonal_, 1e-300));

    // An edge of a triangle, from its lower place to its upper one.
    struct Side {
        unsigned int low, high, face;
        bool forward;
        bool operator<(const Side& other) const {
            return std::pair(low, high) < std::pair(other.low, other.high);
        }
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles_.size());
    std::vector<unsigned int> faceAt; // by place, one that has it
    Together together(faces_.size());
    for (unsigned int f = 0; f < faces_.size(); ++f)
        for (const Triangle& triangle : trianglesOf(faces_[f])) {
            std::array<unsigned int, 3> at{};
            for (std::size_t k = 0; k < 3; ++k) {
                at[k] = places.numberOf(triangle[k]);
                if (at[k] < faceAt.size())
                    together.join(f, faceAt[at[k]]);
                else
                    faceAt.push_back(f);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const unsigned int from = at[k], to = at[(k + 1) % 3];
                if (from != to)
                    sides.push_back({std::min(from, to), std::max(from, to), f, from < to});
            }
        }
    for (unsigned int f = 0; f < faces_.size(); ++f)
        faces_[f].part = together.rootOf(f);

    std::sort(sides.begin(), sides.end());
    std::vector<std::pair<unsigned int, Neighbour>> pairs;
    pairs.reserve(2 * sides.size());
    for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
        while (next < sides.size() && !(sides[i] < sides[next]))
            ++next;
        for (std::size_t a = i; a < next; ++a)
            for (std::size_t b = a + 1;
                 b < (next - i > mostAtAnEdge ? std::min(a + 2, next) : next); ++b) {
                if (sides[a].face == sides[b].face)
                    continue;
                const bool opposed = sides[a].forward == sides[b].forward;
                pairs.push_back({sides[a].face, {sides[b].face, opposed}});
                pairs.push_back({sides[b].face, {sides[a].face, opposed}});
            }
    }
    beginOf_.assign(faces_.size() + 1, 0);
    for (const auto& [face, neighbour] : pairs)
        ++beginOf_[face + 1];
    std::partial_sum(beginOf_.begin(), beginOf_.end(), beginOf_.begin());
    neighbours_.resize(pairs.size());
    std::vector<unsigned int> end(beginOf_.begin(), beginOf_.end() - 1);
    for (const auto& [face, neighbour] : pairs)
        neighbours_[end[face]++] = neighbour;
}

std::vector<IrCodes> FaceMesh::codes(const std::vector<PaintedSurface>& painted) const {
    const PaintedGrid grid(painted);
    std::vector<IrCodes> codes;
    codes.reserve(faces_.size());
    for (const Face& face : faces_) {
        const int surface =
            grid.empty()
                ? -1
                : grid.find(toOsg(face.point), toOsg(face.normal) * (face.turned ? -1.0 : 1.0));
        codes.push_back(surface < 0
                            ? face.codes
                            : painted[static_cast<std::size_t>(surface)].codes.over(face.codes));
    }
    return codes;
}

} // namespace irsg
