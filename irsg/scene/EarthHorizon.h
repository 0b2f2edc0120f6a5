#pragma once

#include <memory>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/scene/FrameRequest.h"

namespace irsg {

class RayMesh;

/// Fills in how the air and the earth's curve let each object be seen: `sight`, `raised_rad`,
/// `hidden` and `hiddenBelow_m`; of one that is all hidden the path is raised to where it would
/// appear, so that air answers for it. The frame then looks along the apparent direction of the
/// object that is nearest to the middle of its field.
void takeApparentDirections(FrameRequest& request, std::vector<ObjectGeometry>& geometry);

/// Of the height of an object at its reference point's range, 0 to 1: what lies below the horizon.
double hiddenByHorizon(const Entity& entity, const ObjectGeometry& object);

/// The ground that hides the lower part of an object, as the flat scene must have it: a wall before
/// the object's sphere, up to the altitude that the horizon hides there, and a sheet over its
/// length at the altitudes that it hides farther on.
struct GroundBefore {
    int entity = 0;
    Pose pose;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const RayMesh> rays; ///< null for OpenGL
};

/// Of each entity that is partly hidden.
std::vector<GroundBefore> groundBefore(const FrameRequest& request,
                                       const std::vector<ObjectGeometry>& geometry, bool forRays);

} // namespace irsg
