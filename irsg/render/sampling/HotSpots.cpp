#include "irsg/render/sampling/HotSpots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

#include "irsg/render/sampling/EntityGroups.h"
#include "irsg/render/sampling/Uniting.h"

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

struct ByPlace {
    bool operator()(const Vec3& a, const Vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

BoundingBox united(BoundingBox a, const BoundingBox& b) {
    a.include(b);
    return a;
}

bool meet(const BoundingBox& a, const BoundingBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

/// Boxes around neighbours among the pieces, at most `most`: the pieces are halved along the
/// longest side of their middles.
void gather(std::span<BoundingBox> pieces, std::size_t most, std::vector<BoundingBox>& boxes) {
    if (pieces.size() <= most) {
        boxes.insert(boxes.end(), pieces.begin(), pieces.end());
        return;
    }
    if (most == 1) {
        boxes.push_back(std::accumulate(pieces.begin() + 1, pieces.end(), pieces[0], united));
        return;
    }
    BoundingBox middles{pieces[0].centre(), pieces[0].centre()};
    for (const BoundingBox& piece : pieces)
        middles.include(piece.centre());
    const Vec3 side = middles.max - middles.min;
    const auto along = [&](const BoundingBox& box) {
        const Vec3 c = box.centre();
        return side.x >= side.y && side.x >= side.z ? std::tuple(c.x, c.y, c.z)
               : side.y >= side.z                   ? std::tuple(c.y, c.z, c.x)
                                                    : std::tuple(c.z, c.x, c.y);
    };
    std::ranges::sort(pieces, {}, along);
    const std::size_t half = pieces.size() / 2;
    gather(pieces.first(half), most / 2, boxes);
    gather(pieces.subspan(half), most - most / 2, boxes);
}

/// From a place to the nearest point of a box.
double distance_m(const Vec3& place, const BoundingBox& box) {
    const Vec3 nearest{std::clamp(place.x, box.min.x, box.max.x),
                       std::clamp(place.y, box.min.y, box.max.y),
                       std::clamp(place.z, box.min.z, box.max.z)};
    return length(place - nearest);
}

} // namespace

std::vector<BoundingBox> connectedPieces(const Mesh& mesh, const IrCodes& codes) {
    UnionFind sets;
    std::map<Vec3, std::size_t, ByPlace> vertexAt;
    for (const Mesh::Part& part : mesh.parts) {
        if (part.codes != codes)
            continue;
        const auto vertex = [&](unsigned index) {
            const auto [place, isNew] = vertexAt.try_emplace(toVec3(part.vertices[index]), 0);
            if (isNew)
                place->second = sets.add();
            return place->second;
        };
        for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
            const std::size_t first = vertex(part.triangles[i]);
            sets.unite(vertex(part.triangles[i + 1]), first);
            sets.unite(vertex(part.triangles[i + 2]), first);
        }
    }

    std::map<std::size_t, BoundingBox> boxOf;
    for (const auto& [place, index] : vertexAt) {
        const BoundingBox point{place, place};
        const auto [box, isNew] = boxOf.try_emplace(sets.find(index), point);
        if (!isNew)
            box->second.include(point);
    }
    std::vector<BoundingBox> pieces;
    for (const auto& [set, box] : boxOf)
        pieces.push_back(box);
    std::ranges::sort(pieces, ByPlace{}, [](const BoundingBox& box) { return box.min; });
    std::vector<BoundingBox> boxes;
    gather(pieces, mostPieces, boxes);
    uniteAll(boxes, meet, united);
    std::ranges::sort(boxes, ByPlace{}, [](const BoundingBox& box) { return box.min; });
    return boxes;
}

SampleTile probeOf(const std::vector<HotSpot>& parts, int entity) {
    constexpr double mostBlocks = 96.0;
    ImageRectangle all;
    for (const HotSpot& part : parts)
        all = all.unitedWith(part.extent);
    const double level = std::floor(std::log2(mostBlocks / std::max(all.extent(), 1e-300)));
    SampleTile probe =
        tileOnBlocks(all, static_cast<int>(std::clamp(level, 0.0, 1.0 * SampleTile::deepestLevel)));
    --probe.blockX, --probe.blockY;
    probe.blocksWide += 2, probe.blocksHigh += 2;
    probe.entities = {entity};
    return probe;
}

ProbedBlocks blocksAround(const HotSpot& part, const SampleTile& probe) {
    const ImageRectangle all = probe.rectangle();
    const double side_px = probe.blockSide_px();
    const auto block = [side_px](double place_px, double origin_px, int count) {
        return std::clamp(static_cast<int>(std::floor((place_px - origin_px) / side_px)), 0,
                          count - 1);
    };
    return {block(part.extent.left - side_px, all.left, probe.blocksWide),
            block(part.extent.right + side_px, all.left, probe.blocksWide),
            block(part.extent.top - side_px, all.top, probe.blocksHigh),
            block(part.extent.bottom + side_px, all.top, probe.blocksHigh)};
}

bool isHidden(const HotSpot& part, const SampleTile& probe, const GeometrySamples& samples) {
    constexpr double nearer = 1.0 - 1e-6; // beyond the rounding of float
    const ProbedBlocks blocks = blocksAround(part, probe);
    for (int row = blocks.top; row <= blocks.bottom; ++row)
        for (int column = blocks.left; column <= blocks.right; ++column) {
            const auto sample = // bottom row first
                static_cast<std::size_t>((probe.blocksHigh - 1 - row) * probe.blocksWide + column);
            if (!samples.isOpaque(sample) ||
                !(static_cast<double>(samples.distances_m[sample]) < nearer * part.nearest_m))
                return false;
        }
    return true;
}

std::vector<HotSpot> HotSpots::seenBy(const CameraFrame& camera, const Pose& pose, const Mesh& mesh,
                                      const std::vector<IrCodes>& hot) {
    std::vector<HotSpot> parts;
    const Sensor& sensor = camera.sensor();
    const ImageRectangle field{0.0, 0.0, static_cast<double>(sensor.width_px),
                               static_cast<double>(sensor.height_px)};
    const Vec3 eye =
        pose.attitude.rotation().transposed() * (camera.viewpoint().position_m - pose.position_m);
    for (const IrCodes& codes : hot) {
        auto found = pieces_.find(codes);
        if (found == pieces_.end())
            found = pieces_.emplace(codes, connectedPieces(mesh, codes)).first;
        for (const BoundingBox& piece : found->second)
            if (const auto extent = camera.extentOf(piece, pose))
                if (const ImageRectangle seen = extent->intersectedWith(field); !seen.empty())
                    parts.push_back({seen, distance_m(eye, piece)});
    }
    return parts;
}

} // namespace irsg
