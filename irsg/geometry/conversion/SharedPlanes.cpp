#include "irsg/geometry/conversion/SharedPlanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "irsg/geometry/conversion/OsgValues.h"

namespace irsg {

std::string toText(const SharedPlane& shared) {
    char text[240];
    std::snprintf(
        text, sizeof text,
        "%d faces of temperature %d, material %d lie in the plane of faces of temperature "
        "%d, material %d, over %.4g m2: those of %d, %d come first in the file and are "
        "drawn",
        shared.faces, shared.hidden.temperature, shared.hidden.material, shared.drawn.temperature,
        shared.drawn.material, shared.area_m2, shared.drawn.temperature, shared.drawn.material);
    return text;
}

namespace {

/// Of coordinates: what single precision leaves of a plane.
constexpr double roundingOfPlace = 5e-7;
constexpr double leastShare = 1e-4; ///< of the smaller triangle
constexpr int highestLayer = 256;
constexpr std::size_t mostInLeaf = 6;

using PlaneCorners = std::array<osg::Vec3d, 3>;

/// A triangle of a mesh.
struct Tile {
    const Mesh::Kind* key;
    const SurfaceMesh::Part* part;
    unsigned int number; ///< in the part

    unsigned int polygon() const { return part->polygonOf[number]; }
    osg::Vec3 vertex(std::size_t corner) const {
        return toOsg(part->vertices[part->triangles[3 * std::size_t{number} + corner]]);
    }
    PlaneCorners corners() const { return {vertex(0), vertex(1), vertex(2)}; }
};

struct Box {
    osg::Vec3 low{HUGE_VALF, HUGE_VALF, HUGE_VALF}, high{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

    void include(const osg::Vec3& place) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], place[axis]);
            high[axis] = std::max(high[axis], place[axis]);
        }
    }
    bool meets(const Box& other, float off) const {
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] > other.high[axis] + off || other.low[axis] > high[axis] + off)
                return false;
        return true;
    }
};

double widthOf(const PlaneCorners& c) {
    return std::sqrt(
        std::max({(c[1] - c[0]).length2(), (c[2] - c[1]).length2(), (c[0] - c[2]).length2()}));
}

/// The area of what a triangle has in common with one in its plane, seen along that plane's unit
/// normal.
double commonArea(const PlaneCorners& one, const PlaneCorners& other, const osg::Vec3d& normal) {
    std::vector<osg::Vec3d> outline(other.begin(), other.end()), kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const osg::Vec3d inward = normal ^ (one[(i + 1) % 3] - one[i]);
        kept.clear();
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const osg::Vec3d &a = outline[k], &b = outline[(k + 1) % outline.size()];
            const double ha = (a - one[i]) * inward, hb = (b - one[i]) * inward;
            if (ha >= 0.0)
                kept.push_back(a);
            if ((ha < 0.0) != (hb < 0.0))
                kept.push_back(a + (b - a) * (ha / (ha - hb)));
        }
        outline.swap(kept);
    }
    osg::Vec3d sum;
    for (std::size_t k = 2; k < outline.size(); ++k)
        sum += (outline[k - 1] - outline[0]) ^ (outline[k] - outline[0]);
    return 0.5 * std::abs(sum * normal);
}

/// What two polygons cover of each other.
struct Cover {
    unsigned int low, high; ///< polygons; the high one is to be drawn
    double area = 0.0;
};

/// A tree of boxes, joined with itself.
class PlaneSearch {
  public:
    explicit PlaneSearch(const SurfaceMesh& mesh) {
        float farthest = 0.0f;
        for (const auto& [key, part] : mesh.parts()) {
            for (unsigned int i = 0; i < part.polygonOf.size(); ++i)
                tiles_.push_back({&key, &part, i});
            for (const auto& [x, y, z] : part.vertices)
                farthest = std::max({farthest, std::abs(x), std::abs(y), std::abs(z)});
        }
        off_ = roundingOfPlace * static_cast<double>(farthest);
        nodes_.reserve(tiles_.size() / 2 + 16);
        build(0, tiles_.size());
        if (!tiles_.empty())
            join(0, 0);
    }

    std::vector<Cover> covers;
    std::vector<const Mesh::Kind*> keyOf(unsigned int polygons) const {
        std::vector<const Mesh::Kind*> keys(polygons, nullptr);
        for (const Tile& tile : tiles_)
            keys[tile.polygon()] = tile.key;
        return keys;
    }

  private:
    struct Node {
        Box box;
        const IrCodes* codes = nullptr; ///< of all its tiles, or null for several
        std::size_t first = 0, end = 0; ///< tiles
        std::size_t left = 0, right = 0;
        bool isLeaf() const { return right == 0; }
    };

    std::size_t build(std::size_t first, std::size_t end) {
        const std::size_t number = nodes_.size();
        Node node;
        node.first = first;
        node.end = end;
        Box middles;
        for (std::size_t i = first; i < end; ++i) {
            const Tile& tile = tiles_[i];
            for (std::size_t corner = 0; corner < 3; ++corner)
                node.box.include(tile.vertex(corner));
            middles.include(middleOf(tile));
            if (i == first)
                node.codes = &tile.key->codes;
            else if (node.codes && *node.codes != tile.key->codes)
                node.codes = nullptr;
        }
        nodes_.push_back(node);
        if (end - first <= mostInLeaf || node.codes)
            return number;
        const osg::Vec3 extent = middles.high - middles.low;
        const int axis = extent.x() >= extent.y() && extent.x() >= extent.z() ? 0
                         : extent.y() >= extent.z()                           ? 1
                                                                              : 2;
        const auto begin = tiles_.begin();
        const std::size_t middle = (first + end) / 2;
        const auto at = [begin](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(end), [axis](const Tile& a, const Tile& b) {
            return middleOf(a)[axis] < middleOf(b)[axis];
        });
        const std::size_t left = build(first, middle), right = build(middle, end);
        nodes_[number].left = left;
        nodes_[number].right = right;
        return number;
    }

    static osg::Vec3 middleOf(const Tile& tile) {
        return tile.vertex(0) + tile.vertex(1) + tile.vertex(2);
    }

    void join(std::size_t one, std::size_t other) {
        const Node &a = nodes_[one], &b = nodes_[other];
        if (a.codes && b.codes && *a.codes == *b.codes)
            return;
        if (!a.box.meets(b.box, static_cast<float>(off_)))
            return;
        if (a.isLeaf() && b.isLeaf()) {
            for (std::size_t i = a.first; i < a.end; ++i)
                for (std::size_t k = one == other ? i + 1 : b.first; k < b.end; ++k)
                    compare(tiles_[i], tiles_[k]);
        } else if (one == other) {
            join(a.left, a.left);
            join(a.right, a.right);
            join(a.left, a.right);
        } else if (b.isLeaf() || (!a.isLeaf() && a.end - a.first >= b.end - b.first)) {
            join(a.left, other);
            join(a.right, other);
        } else {
            join(one, b.left);
            join(one, b.right);
        }
    }

    void compare(const Tile& one, const Tile& other) {
        if (one.key->codes == other.key->codes)
            return;
        Box boxes[2];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            boxes[0].include(one.vertex(corner));
            boxes[1].include(other.vertex(corner));
        }
        if (!boxes[0].meets(boxes[1], static_cast<float>(off_)))
            return;
        const PlaneCorners corners[2] = {one.corners(), other.corners()};
        osg::Vec3d normals[2];
        for (std::size_t i = 0; i < 2; ++i)
            normals[i] = (corners[i][1] - corners[i][0]) ^ (corners[i][2] - corners[i][0]);
        const double areas[2] = {0.5 * normals[0].length(), 0.5 * normals[1].length()};
        // The plane of the larger one is known better.
        const std::size_t large = areas[0] >= areas[1] ? 0 : 1, small = 1 - large;
        if (!(areas[small] > 0.0))
            return;
        const osg::Vec3d normal = normals[large] / (2.0 * areas[large]);
        for (const osg::Vec3d& corner : corners[small])
            if (std::abs((corner - corners[large][0]) * normal) > off_)
                return;
        if (one.key->culled && other.key->culled && normals[0] * normals[1] < 0.0)
            return;
        const double common = commonArea(corners[large], corners[small], normal);
        if (common <= leastShare * areas[small] + 4.0 * off_ * widthOf(corners[small]))
            return;
        const auto rank = [](const Tile& tile) {
            return std::pair(tile.key->layer, ~tile.polygon());
        };
        const bool isHigh = rank(one) > rank(other);
        covers.push_back(
            {(isHigh ? other : one).polygon(), (isHigh ? one : other).polygon(), common});
    }

    std::vector<Tile> tiles_;
    std::vector<Node> nodes_;
    double off_ = 0.0;
};

bool hasSeveralCodes(const SurfaceMesh& mesh) {
    return std::ranges::any_of(mesh.parts(), [&](const auto& part) {
        return part.first.codes != mesh.parts().begin()->first.codes;
    });
}

} // namespace

std::vector<SharedPlane> settleSharedPlanes(SurfaceMesh& mesh) {
    if (!hasSeveralCodes(mesh))
        return {};
    PlaneSearch search(mesh);
    auto& covers = search.covers;
    if (covers.empty())
        return {};
    const auto keys = search.keyOf(mesh.polygons());
    const auto rank = [&](unsigned int polygon) {
        return std::pair(keys[polygon]->layer, ~polygon);
    };
    std::ranges::sort(covers, [&](const Cover& a, const Cover& b) {
        return std::tuple(rank(a.high), rank(a.low), a.area) <
               std::tuple(rank(b.high), rank(b.low), b.area);
    });

    // Those below have their layers by then: each is above what it covers.
    std::vector<int> layers(mesh.polygons(), -1);
    const auto layerOf = [&](unsigned int polygon) {
        return std::max(layers[polygon], keys[polygon]->layer);
    };
    bool isLifted = false;
    using Pair = std::pair<IrCodes, IrCodes>;
    std::map<Pair, std::pair<double, std::set<unsigned int>>> pairs;
    for (const Cover& cover : covers) {
        if (layerOf(cover.high) <= layerOf(cover.low)) {
            layers[cover.high] = std::min(layerOf(cover.low) + 1, highestLayer);
            isLifted = true;
        }
        if (keys[cover.high]->layer != keys[cover.low]->layer)
            continue; // a subface, as the file wants it
        auto& pair = pairs[{keys[cover.high]->codes, keys[cover.low]->codes}];
        pair.first += cover.area;
        pair.second.insert(cover.low);
    }
    if (isLifted)
        mesh.setLayers(layers);
    std::vector<SharedPlane> settled;
    for (const auto& [codes, pair] : pairs)
        settled.push_back(
            {codes.first, codes.second, static_cast<int>(pair.second.size()), pair.first});
    std::ranges::stable_sort(settled, std::greater(), &SharedPlane::area_m2);
    return settled;
}

} // namespace irsg
