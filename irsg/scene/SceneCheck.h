#pragma once

#include <vector>

#include "irsg/geometry/view/Sensor.h"
#include "irsg/radiance/SceneAtmosphere.h"

namespace irsg {

/// What the air is asked for, per object. Throws InputError for a sensor or a target below ground.
std::vector<ObjectGeometry> objectGeometry(const std::vector<Entity>& entities,
                                           const std::vector<Vec3>& referencePoints,
                                           const Viewpoint& viewpoint);

/// Throws InputError with every diagnostic of the scene: sensor, settings, faces without an entry
/// (codes and face counts), user-defined spectra that are missing, surface spectra that do not
/// cover the bands, temperatures that are not positive, and air without the calculation mode.
void checkScene(const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
                const Environment& environment, const Sensor& sensor,
                const std::vector<Band>& bands, const RenderSettings& settings);

} // namespace irsg
