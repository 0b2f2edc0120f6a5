#pragma once

#include <functional>
#include <vector>

#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/scene/ObjectSilhouette.h"

namespace irsg {

/// Of the change of the background over an object: what is wrong because the grid that tells
/// which parts hide each other has an end, and opacities are means over the band. Measured, see
/// docs/errors.md.
inline constexpr double errorOfOverlap = 0.03;

/// Lines of sight whose weighted sum is the background behind an object, and how far off it is.
struct SightsBehind {
    std::vector<SightBehind> sights;
    /// By output: what twice as many lines would change, and what overlapping parts may.
    std::vector<double> error;
};

/// Radiance along a line of sight, by output.
using RadianceAlong = std::function<std::vector<double>(const LineOfSight&)>;

/// Chooses lines of sight behind an object: one along its own apparent direction where the
/// background can't change over it, else as many rows as its error asks for. Rows stand on either
/// side of the horizon, from the lowest to the highest direction of the object's sphere, so that
/// all aspects share them; those that no slice needs are left out. Between three rows the radiance
/// is a parabola, in the elevation above the horizon and in the root of the angle below it. Rows
/// are doubled until that changes the background by less than 0.001 %, from three up to 65 on a
/// side.
///
/// `reach_rad`: of the sphere about the reference point. `slices`: of its silhouette, asked for
/// only where rows are needed. An air that answers for the one direction alone is asked for that.
SightsBehind sightsBehind(const ObjectGeometry& object, double horizon_rad, double reach_rad,
                          const std::function<std::vector<SilhouettePart>()>& slices,
                          const RadianceAlong& radianceAlong);

} // namespace irsg
