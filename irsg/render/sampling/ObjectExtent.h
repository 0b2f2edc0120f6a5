#pragma once

#include <optional>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/sampling/SampleLattice.h"

namespace irsg {

/// Where an object is seen: what a strategy plans its tiles from.
struct ObjectExtent {
    int entity = 0;
    /// Holds every pixel the object can touch; the part inside the frame.
    ImageRectangle extent;
    /// A sphere around it in the world.
    Vec3 centre_m;
    double radius_m = 0.0;
    /// Parts of the extent that are worth samples of their own (HotSpots).
    std::vector<ImageRectangle> details{};
    /// Its long straight edges as they are seen (LongEdges).
    std::vector<ImageEdge> edges{};
};

/// The extent of a model at `pose` is the intersection of those of its box and its sphere. Nothing
/// where it lies behind the camera or outside the frame; the whole frame where it reaches behind
/// the camera.
std::optional<ObjectExtent> objectExtent(int entity, const CameraFrame& camera, const Mesh& mesh,
                                         const Pose& pose);

} // namespace irsg
