#pragma once

#include <string>
#include <vector>

#include "irsg/scene/Scene.h"

namespace smat {

/// A sentence for each lookup table of an entity's database that is clamped to an end value in a
/// state, because its axis does not reach it. Altitude and aspect angle are those of
/// `referencePoint` (in the world) as seen from `camera`.
std::vector<std::string> clampedTableWarnings(const irsg::Entity& entity, irsg::EntityState state,
                                              const irsg::Pose& pose,
                                              const irsg::Vec3& referencePoint,
                                              const irsg::Vec3& camera);

/// True where a vertex of the target lies outside the frame or behind the camera. What is not in
/// the frame is not in the sums. Never true for an entity without a model.
bool reachesBeyondFrame(const irsg::Entity& target, const irsg::Pose& pose,
                        const irsg::Viewpoint& viewpoint, const irsg::Sensor& sensor);
/// The sentence that says so of an entity.
std::string beyondFrameWarning(const std::string& entity);

} // namespace smat
