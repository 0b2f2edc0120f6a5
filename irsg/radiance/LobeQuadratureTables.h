#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "irsg/geometry/view/Vec3.h"
#include "irsg/radiance/SpecularEnvironmentGrid.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// Where the lobes of a model lie among the places of a SpecularEnvironmentGrid, for one direction
/// of view and any mirror direction: known at the nodes of a grid over the sphere of mirror
/// directions, as fine as the lobe is wide, between three of which it is linear. Nodes come into
/// being when they are first asked for, whatever the order, so that a frame pays for those that it
/// sees, once.
///
/// Axes: z up; x along the level part of the direction of view, or where air answers by azimuth
/// towards the azimuth of the sun. What is off by the direction of view, which is at most half a
/// cell from that of the table, is the shape of a lobe alone, not its place.
class LobeQuadratureTable final : public SpecularEnvironmentTable {
  public:
    /// Angles between directions of view that have a table each.
    static constexpr double cell_rad = 1.0 / 32.0;
    /// Smoother surfaces are reflected facet by facet: their tables would have more nodes than a
    /// picture has samples.
    static constexpr double leastRoughness = 0.05;
    static bool serves(const SurfaceModel& model) { return model.roughness() >= leastRoughness; }

    /// Elevation of the direction towards the eye, and its azimuth from the sun's, in cells.
    struct ViewCell {
        int elevation = 0, azimuth = 0;
        auto operator<=>(const ViewCell&) const = default;
    };
    /// `view`: unit, in the table's axes.
    static ViewCell cellOf(const Vec3& view, bool byAzimuth);

    LobeQuadratureTable(std::shared_ptr<const SurfaceModel> model,
                        const SpecularEnvironmentGrid& grid, ViewCell cell);

    /// Divisions of an octant's edges, of a model.
    static std::uint32_t divisionsOf(const SurfaceModel& model);
    /// Keys of the nodes about a unit vector, and their weights, which add up to 1.
    struct About {
        std::array<std::uint32_t, 3> keys{};
        std::array<float, 3> weights{};
    };
    static About about(const Vec3& mirror, std::uint32_t divisions);

    /// The number of a node, which may have to be filled.
    std::uint32_t nodeOf(std::uint32_t key);
    /// Computes the nodes that were asked for since the last time, on all cores.
    void fill();
    std::size_t nodes() const { return keys.size(); }

  private:
    Vec3 directionOf(std::uint32_t key) const;
    void fillNode(std::size_t node);

    std::shared_ptr<const SurfaceModel> model_;
    SpecularEnvironmentGrid grid_;
    Vec3 view_;
    std::uint32_t divisions_;
    std::vector<SurfaceDirection> facets_; // and their mirror images in the plane of view
    std::vector<std::int32_t> numbers_;    // by key; -1 for none
    std::size_t filled_ = 0;
};

/// The tables of a renderer, for all frames.
class LobeQuadratureTables {
  public:
    std::shared_ptr<LobeQuadratureTable> of(const std::shared_ptr<const SurfaceModel>& model,
                                            const SpecularEnvironmentGrid& grid,
                                            LobeQuadratureTable::ViewCell cell);

  private:
    static constexpr std::size_t mostNodes = 400'000;
    using Key =
        std::tuple<const SurfaceModel*, std::array<double, 2>, LobeQuadratureTable::ViewCell>;
    std::map<Key, std::shared_ptr<LobeQuadratureTable>> tables_;
};

} // namespace irsg
