#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/radiance/GasZones.h"
#include "irsg/radiance/OccluderStacks.h"

namespace irsg {

/// What a sample of a surface is, radiometrically: its entity and the codes that fix its spectra.
using SurfaceKey = std::pair<int, IrCodes>;

/// The distances from the sensor at which the air of an entity is known, m, ascending and evenly
/// spaced. Less than two: the air is that of the reference point wherever a sample lies.
using SliceNodes = std::vector<double>;

/// A node of slices between two of those that are taken.
struct SliceBetween {
    int below = 0, above = 0;
    double part = 0.0; ///< how far from `below`; 0 where that is the node itself
};

/// About a node, where every `step`th is taken from the first on, and the last, which is `last`.
SliceBetween sliceBetween(int node, int step, int last);

/// What a directional surface sends beside a Lambertian one: of a component of its model, or of
/// what that reflects in a lobe of the atmosphere's radiance at a place of a
/// SpecularEnvironmentGrid, or of other surfaces.
struct LobeQuadratureRow {
    static constexpr int none = -1, surfaces = -2;
    int surface = 0; ///< drawn row
    int component = 0;
    int light = none; ///< place of the grid, or of these
    bool isOfAtmosphere() const { return light >= 0; }
    bool isOfSurfaces() const { return light == surfaces; }
    bool operator==(const LobeQuadratureRow&) const = default;
};

/// The rows of a drawing and what the radiometry makes of each: one row, or one for every node of
/// its entity's range slices, next to each other.
class SurfaceRows {
  public:
    SurfaceRows() = default;
    /// `transparent`: by key. `slices`: by entity. `gases`: by drawn row, of those that are the
    /// boundary of one.
    SurfaceRows(std::vector<SurfaceKey> keys, const std::vector<bool>& transparent,
                std::vector<SliceNodes> slices, std::vector<LobeQuadratureRow> lobes = {},
                std::map<int, GasZone> gases = {});

    /// Of the surfaces that are drawn.
    const std::vector<SurfaceKey>& keys() const { return keys_; }
    /// Rows of lobes stand behind those of surfaces, those of a surface next to each other.
    const std::vector<LobeQuadratureRow>& lobes() const { return lobes_; }
    bool isLobe(int drawn) const { return static_cast<std::size_t>(drawn) >= keys_.size(); }
    const LobeQuadratureRow& lobe(int drawn) const {
        return lobes_[static_cast<std::size_t>(drawn) - keys_.size()];
    }
    /// The first of the lobes of a surface; -1 for none.
    int firstLobe(int drawn) const { return rendered_[static_cast<std::size_t>(drawn)].firstLobe; }
    /// Whether it is what lobes reflect of other surfaces.
    bool isOfSurfaces(int drawn) const { return isLobe(drawn) && lobe(drawn).isOfSurfaces(); }
    /// The surface that a row or a lobe is of.
    int surfaceOf(int drawn) const { return isLobe(drawn) ? lobe(drawn).surface : drawn; }
    const SurfaceKey& keyOf(int drawn) const {
        return keys_[static_cast<std::size_t>(surfaceOf(drawn))];
    }
    /// Of surfaces and lobes.
    std::size_t renderedCount() const { return rendered_.size(); }
    bool isSliced(int drawn) const {
        return rendered_[static_cast<std::size_t>(drawn)].lastSlice >= 0;
    }
    bool isTransparent(int drawn) const {
        return rendered_[static_cast<std::size_t>(drawn)].isTransparent;
    }
    /// Null for a surface.
    const GasZone* gas(int drawn) const {
        const auto found = gases_.find(drawn);
        return found == gases_.end() ? nullptr : &found->second;
    }
    const std::map<int, GasZone>& gases() const { return gases_; }
    bool hasGas() const { return !gases_.empty(); }
    /// Whether samples need the distance of what they show.
    bool needsDistances() const { return isSliced_ || hasGas(); }
    OccluderMaterial material(int drawn) const {
        const auto& [entity, codes] = keyOf(drawn);
        return {entity, codes.material};
    }
    /// The first of a drawn row's rows; of the one behind the last the number of all.
    int first(int drawn) const {
        const auto number = static_cast<std::size_t>(drawn);
        return number < rendered_.size() ? rendered_[number].first : size();
    }
    /// Number of all rows.
    int size() const { return static_cast<int>(renderedOf_.size()); }
    int renderedOf(int row) const { return renderedOf_[static_cast<std::size_t>(row)]; }
    /// 0 for the nearest node.
    int nodeOf(int row) const { return row - first(renderedOf(row)); }

    const std::vector<SliceNodes>& slices() const { return slices_; }
    bool isSliced() const { return isSliced_; }

    /// What a sample of a drawn row at a distance belongs to: a row, or two nodes next to each
    /// other, between which radiance is linear.
    struct Between {
        int row = 0;
        float next = 0.0f; ///< the weight of the row behind it; 1 - next is that of the row
    };
    [[gnu::always_inline]] Between at(int drawn, float distance_m) const {
        const Rendered& own = rendered_[static_cast<std::size_t>(drawn)];
        if (own.lastSlice < 0)
            return {own.first, 0.0f};
        // Without a branch: every layer of every sample comes here.
        const double from = (static_cast<double>(distance_m) - own.nearest_m) * own.slicesPerMetre;
        const double place = std::min(std::max(from, 0.0), own.lastSlice + 1.0);
        const int node = std::min(static_cast<int>(place), own.lastSlice);
        return {own.first + node, static_cast<float>(place - node)};
    }
    /// Calls visit(row, weight) for it, or for both of them.
    template <typename Visit>
    void forEachRow(int drawn, float distance_m, Visit visit) const {
        const Between between = at(drawn, distance_m);
        visit(between.row, 1.0f - between.next);
        if (rendered_[static_cast<std::size_t>(drawn)].lastSlice >= 0)
            visit(between.row + 1, between.next);
    }

    bool operator==(const SurfaceRows&) const = default;

  private:
    std::vector<SurfaceKey> keys_;
    std::vector<LobeQuadratureRow> lobes_;
    std::vector<SliceNodes> slices_;
    std::map<int, GasZone> gases_; // by drawn row
    std::vector<int> renderedOf_;  // by row
    bool isSliced_ = false;
    /// What the walk through samples asks of a drawn row.
    struct Rendered {
        bool isTransparent = false;
        int first = 0;      // of its rows
        int firstLobe = -1; // drawn row
        int lastSlice = -1; // -1: not sliced
        double nearest_m = 0.0, slicesPerMetre = 0.0;
        bool operator==(const Rendered&) const = default;
    };
    std::vector<Rendered> rendered_; // by key, then by lobe
};

} // namespace irsg
