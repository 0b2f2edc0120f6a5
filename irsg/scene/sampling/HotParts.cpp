#include "irsg/scene/sampling/HotParts.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <osg/TriangleIndexFunctor>

#include "irsg/scene/sampling/Uniting.h"

namespace irsg {

namespace {

/// Sets of vertices that grow together.
class UnionFind {
  public:
    std::size_t add() {
        parent_.push_back(parent_.size());
        return parent_.size() - 1;
    }
    std::size_t find(std::size_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
    std::size_t size() const { return parent_.size(); }

  private:
    std::vector<std::size_t> parent_;
};

struct Triangles {
    std::vector<std::array<unsigned, 3>> corners;
    void operator()(unsigned a, unsigned b, unsigned c) { corners.push_back({a, b, c}); }
};

struct ByPlace {
    bool operator()(const Vec3& a, const Vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

BoundingBox united(const BoundingBox& a, const BoundingBox& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

bool meet(const BoundingBox& a, const BoundingBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

double area_px2(const ImageRectangle& r) {
    return r.empty() ? 0.0 : r.width() * r.height();
}

} // namespace

std::vector<BoundingBox> connectedPieces(const std::vector<DrawItem>& items, const IrCodes& codes) {
    UnionFind sets;
    std::map<Vec3, std::size_t, ByPlace> vertexAt;
    for (const DrawItem& item : items) {
        const auto* vertices = dynamic_cast<const osg::Vec3Array*>(item.geometry->getVertexArray());
        if (item.codes != codes || !vertices)
            continue;
        osg::TriangleIndexFunctor<Triangles> triangles;
        item.geometry->accept(triangles);
        const auto vertex = [&](unsigned index) {
            const osg::Vec3d p = osg::Vec3d((*vertices)[index]) * item.modelFromLocal;
            const auto [place, isNew] = vertexAt.try_emplace(Vec3{p.x(), p.y(), p.z()}, 0);
            if (isNew)
                place->second = sets.add();
            return place->second;
        };
        for (const auto& [a, b, c] : triangles.corners) {
            const std::size_t first = vertex(a);
            sets.unite(vertex(b), first);
            sets.unite(vertex(c), first);
        }
    }

    std::map<std::size_t, BoundingBox> boxOf;
    for (const auto& [place, index] : vertexAt) {
        const BoundingBox point{place, place};
        const auto [box, isNew] = boxOf.try_emplace(sets.find(index), point);
        if (!isNew)
            box->second = united(box->second, point);
    }
    std::vector<BoundingBox> pieces;
    for (const auto& [set, box] : boxOf)
        pieces.push_back(box);
    std::ranges::sort(pieces, ByPlace{}, [](const BoundingBox& box) { return box.min; });
    constexpr std::size_t mostPieces = 256; // beyond, their boxes are not compared pair by pair
    if (pieces.size() <= mostPieces)
        uniteAll(pieces, meet, united);
    return pieces;
}

std::vector<ImageRectangle> HotParts::seenBy(const CameraFrame& camera, const Pose& pose,
                                             const std::vector<DrawItem>& items,
                                             const std::vector<IrCodes>& hot) {
    std::vector<ImageRectangle> details;
    const Sensor& sensor = camera.sensor();
    const ImageRectangle field{0.0, 0.0, static_cast<double>(sensor.width_px),
                               static_cast<double>(sensor.height_px)};
    for (const IrCodes& codes : hot) {
        auto found = pieces_.find(codes);
        if (found == pieces_.end())
            found = pieces_.emplace(codes, connectedPieces(items, codes)).first;
        if (found->second.size() > mostDetails)
            continue;
        for (const BoundingBox& piece : found->second)
            if (const auto extent = camera.extentOf(piece, pose))
                if (const ImageRectangle seen = extent->intersectedWith(field); !seen.empty())
                    details.push_back(seen);
    }

    // One window where two would hold much the same.
    constexpr double mostWaste = 1.25;
    uniteAll(
        details,
        [](const ImageRectangle& a, const ImageRectangle& b) {
            return area_px2(a.unitedWith(b)) <= mostWaste * (area_px2(a) + area_px2(b));
        },
        [](const ImageRectangle& a, const ImageRectangle& b) { return a.unitedWith(b); });
    if (details.size() > mostDetails)
        details.clear();
    return details;
}

} // namespace irsg
