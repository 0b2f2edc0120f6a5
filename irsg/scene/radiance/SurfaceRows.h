#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "irsg/scene/model/ModelValues.h"
#include "irsg/scene/radiance/Fronts.h"

namespace irsg {

/// What a sample of a surface is, radiometrically: its entity and the codes that fix its spectra.
using SurfaceKey = std::pair<int, IrCodes>;

/// The distances from the sensor at which the air of an entity is known, m, ascending and evenly
/// spaced. Less than two: the air is that of the reference point wherever a sample lies.
using SliceNodes = std::vector<double>;

/// The rows of a drawing and what the radiometry makes of each: one row, or one for every node of
/// its entity's range slices, next to each other.
class SurfaceRows {
  public:
    SurfaceRows() = default;
    /// `transparent`: by key. `slices`: by entity.
    SurfaceRows(std::vector<SurfaceKey> keys, std::vector<bool> transparent,
                std::vector<SliceNodes> slices);

    const std::vector<SurfaceKey>& keys() const { return keys_; }
    bool isTransparent(int drawn) const { return transparent_[static_cast<std::size_t>(drawn)]; }
    FrontMaterial material(int drawn) const {
        const auto& [entity, codes] = keys_[static_cast<std::size_t>(drawn)];
        return {entity, codes.material};
    }
    /// The first of a drawn row's rows.
    int first(int drawn) const { return first_[static_cast<std::size_t>(drawn)]; }
    /// Number of all rows.
    int size() const { return first_.empty() ? 0 : first_.back(); }
    int drawnOf(int row) const { return drawnOf_[static_cast<std::size_t>(row)]; }
    /// 0 for the nearest node.
    int nodeOf(int row) const { return row - first(drawnOf(row)); }

    const std::vector<SliceNodes>& slices() const { return slices_; }
    bool isSliced() const { return isSliced_; }

    /// Calls visit(row, weight) for the rows that a sample of a drawn row at a distance belongs to:
    /// one of weight 1, or the two nodes around it, between which radiance is linear.
    template <typename Visit>
    void forEachRow(int drawn, float distance_m, Visit visit) const {
        const int row = first(drawn);
        if (!isSliced_)
            return visit(row, 1.0f);
        const auto& nodes_m =
            slices_[static_cast<std::size_t>(keys_[static_cast<std::size_t>(drawn)].first)];
        if (nodes_m.size() < 2)
            return visit(row, 1.0f);
        const auto [node, part] = nodeAt(nodes_m, static_cast<double>(distance_m));
        visit(row + node, 1.0f - part);
        visit(row + node + 1, part);
    }

    bool operator==(const SurfaceRows&) const = default;

  private:
    /// The node before a distance, at most the last but one, and the part of the way to the next.
    static std::pair<int, float> nodeAt(const SliceNodes& nodes_m, double distance_m) {
        const auto slices = static_cast<double>(nodes_m.size() - 1);
        const double place =
            std::clamp((distance_m - nodes_m.front()) / (nodes_m.back() - nodes_m.front()) * slices,
                       0.0, slices);
        const int node = std::min(static_cast<int>(place), static_cast<int>(slices) - 1);
        return {node, static_cast<float>(place - node)};
    }

    std::vector<SurfaceKey> keys_;
    std::vector<bool> transparent_;
    std::vector<SliceNodes> slices_;
    std::vector<int> first_;   // by key, and the number of all rows
    std::vector<int> drawnOf_; // by row
    bool isSliced_ = false;
};

} // namespace irsg
