#pragma once

#include "irsg/radiance/SceneSampling.h"

namespace irsg {

/// Gives the air of a sampled band `scene.pathDepth` times its optical depth between each object
/// and the sensor, at every node: the transmittance is tau^depth, and the path radiance that of the
/// path's mean source function, L (1 - tau^depth) / (1 - tau), which is exact in air of one
/// temperature and source, and else right to first order in what the source differs along the path.
///
/// What is behind an object is seen through the same air. B, what arrives of it, is L + tau L',
/// with the radiance L' that enters the path behind the object; it becomes that of the other air
/// with L' as it is. So the contrast of an object that hides it becomes tau^(depth - 1) of itself
/// at every node, whatever the source function. The transmittance that a measured spectrum is
/// divided by stays, as do the light onto objects and the air in front of lobes.
void deepenPaths(AtmosphericQueryCache& answers, const AtmosphereScene& scene, SampledBand& band);

} // namespace irsg
