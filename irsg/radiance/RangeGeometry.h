#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/ViewGeometry.h"

namespace irsg {

/// The factors of an object along a straight line of sight. Times the square of the distance d they
/// are smooth functions of its nearness h / d, where h is how far the object reaches from its
/// reference point, so that those of a few distances, the nodes, give those of any other.
///
/// Between two nodes they are the mean of the parabolas through either and their neighbours,
/// weighted so that the slope has no steps. Errors of the intensity beside those of sampling, up to
/// the nearness `closest`: 1e-4 RMS for the sample aircraft; 2e-3 at most where a side as large as
/// the front comes into sight at some distance, because that corner of the curve is rounded.
/// Nearer by objects are drawn.
class RangeGeometry {
  public:
    /// Where the kinds of a view are, by front and drawn row: squares in the plane through the
    /// object's reference point across the line of sight, given by their middles, with the coverage
    /// that each stands for.
    struct KindPlace {
        double right_m, up_m, coverage;
    };
    struct KindPlaces {
        double side_m;
        std::map<std::pair<int, int>, std::vector<KindPlace>> byKind;
    };
    /// The factors from one distance, and where they are; no places where nobody asked for them.
    struct FromOne {
        double distance_m;
        ViewGeometry view;
        std::optional<KindPlaces> places;
    };

    static constexpr double closest = 1.0 / 16.0;
    /// Nearness of the nodes. The first is the farthest that float tells depths at, and stands for
    /// those beyond as well.
    static constexpr std::array<double, 5> nodes = {1.0 / 4096, 1.0 / 64, 2.0 / 64, 3.0 / 64,
                                                    closest};
    /// Slices that an object has in a node's drawing where its air is sliced.
    static constexpr std::size_t slices = 64;
    /// The same in the drawing from one distance.
    static constexpr std::size_t slicesFromOne = 4;
    /// The same line of sight from another range: of the components of a unit vector.
    static constexpr double directionStep = 1e-8;

    struct Weight {
        std::size_t node;
        double weight;
    };
    /// The nodes that a nearness from 0 to `closest` takes its factors from; their weights add
    /// to 1.
    static std::vector<Weight> weightsAt(double nearness);

    /// Weights of what the mean of the parabolas is likely to leave wrong: the cubic through four
    /// nodes less that mean. They take one node more beyond the first and the last but one.
    static std::vector<Weight> errorWeightsAt(double nearness);

    /// Factors of an entity at a node, kept for its aspect, as they are at unit distance: coverage
    /// and factors in sr m2, pixels in those of pixels 1 m wide at 1 m.
    const ViewGeometry& at(int entity, const PointAspect& aspect, std::size_t node,
                           const std::function<ViewGeometry()>& draw);

    /// The same from one distance, which stands for all of the aspect, and by how much it is off at
    /// another nearness at most, as a share of it (see Outputs::Reports::alongRangeFrom).
    const FromOne& from(int entity, const PointAspect& aspect, double distance_m, bool withPlaces,
                        const std::function<FromOne()>& draw);
    /// That distance for one that is asked for: no object is sampled from nearer than `closest`.
    static double sampledFrom_m(double asked_m, double reach_m) {
        return std::max(asked_m, reach_m / closest);
    }
    static double errorFrom(double sampledNearness, double nearness) {
        return 2.0 * std::abs(sampledNearness - nearness);
    }

  private:
    struct CacheEntry {
        PointAspect aspect;
        std::array<std::optional<ViewGeometry>, nodes.size()> atNode;
        std::optional<FromOne> fromOne;
    };
    CacheEntry& entryOf(int entity, const PointAspect& aspect);

    static constexpr std::size_t mostCached = 4;    ///< aspects of an entity
    std::map<int, RecentlyUsed<CacheEntry>> cache_; // by entity
};

/// Where along its line of sight an object is seen.
struct RangePlace {
    double range_m = 0.0;   ///< to the reference point
    double pixel_rad = 0.0; ///< width of a pixel at unit depth
};

/// The mean radiance behind a kind of the drawing, W m-2 sr-1, by background of the view.
using RadianceBehindKind = std::function<std::vector<double>(const SurfaceStackId&)>;

/// Adds factors as RangeGeometry keeps them to a view. Slices of the object are those of `drawn`
/// around `drawn_m`; they move to the object's range and are shared among the slices of `rows`.
/// `behind` is asked where backgrounds of the view vary.
void addAtRange(const ViewGeometry& atUnitDistance, double weight, const SurfaceRows& drawn,
                double drawn_m, const SurfaceRows& rows, const RangePlace& place,
                const RadianceBehindKind& behind, ViewGeometry& view);

} // namespace irsg
