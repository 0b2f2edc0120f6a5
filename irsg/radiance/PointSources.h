#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/radiance/ViewGeometry.h"

namespace irsg {

/// From where an object is seen and lit: what its factors depend on but for its distance.
struct PointAspect {
    std::shared_ptr<const Model> model;
    /// Directions in model axes, window, angle factors, transparency.
    std::vector<double> numbers;
    std::string shader; ///< how factors are made

    bool operator==(const PointAspect&) const = default;
};

/// Objects so small that drawing them for every frame is waste. Their factors are drawn
/// once and serve at every range and place in the frame while the object is seen and lit from the
/// same directions. All of an object goes to the pixel that holds its middle.
///
/// Errors: as far as an object lies across a border of pixels, its energy is in the pixel next to
/// the true one, at most half its extent in pixels (RenderSettings::pointSourceBelow_px). The
/// direction it is seen from is rounded to a grid, so that what is kept does not depend on who saw
/// it first: a plate seen at the grazing angle g changes by directionStep over tan g. Other than
/// that the intensity is the one of a drawn window.
class PointSources {
  public:
    static constexpr double directionStep = 1e-4; ///< of the components of a unit vector
    /// Where the camera stands that draws an object, in radii of its bounding sphere: the rays are
    /// parallel.
    static constexpr double cameraDistance_radii = 1e6;

    /// The nearest direction on a grid.
    static Vec3 onGrid(const Vec3& direction, double step = directionStep);

    /// Sums of an entity times the square of its distance, whose rows are those of the drawing.
    /// `draw` makes them where none that are kept are of this aspect.
    const PointGeometry& of(int entity, const PointAspect& aspect,
                            const std::function<PointGeometry()>& draw);

  private:
    struct CacheEntry {
        PointAspect aspect;
        PointGeometry factors;
    };
    /// Aspects that are kept of an entity: one that moves a pixel to and fro is seen from the
    /// neighbours of a point of the grid in turn.
    static constexpr std::size_t mostCached = 16;
    std::map<int, RecentlyUsed<CacheEntry>> cache_; // by entity
};

} // namespace irsg
