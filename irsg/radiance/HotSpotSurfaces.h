#pragma once

#include <vector>

#include "irsg/radiance/SceneRadiometry.h"

namespace irsg {

/// True for each drawn row of a scene that shines out of its object in any of the bands: its
/// in-band thermal radiance at the sensor is at least `hotFrom` times the mean of the object's
/// area, and it holds at least `shareFrom` of what that area emits. An exhaust pipe is one, skin in
/// the sun is not. The samples of a window that holds the whole object are too far apart for such
/// surfaces where they are small.
std::vector<bool> hotSpotSurfaces(const SceneRadiometry& radiometry,
                                  const std::vector<Entity>& entities);
inline constexpr double hotFrom = 4.0;
inline constexpr double shareFrom = 0.01;

/// True for each drawn row whose temperature makes it at least `hotFrom` times as bright at 4 um as
/// the mean of its object's area: the same whatever is asked of the scene. Gas is none.
std::vector<bool> hotSurfaces(const SceneRadiometry& radiometry,
                              const std::vector<Entity>& entities);

} // namespace irsg
