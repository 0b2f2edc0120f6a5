#include "irsg/render/sampling/ObjectExtent.h"

namespace irsg {

std::optional<ObjectExtent> objectExtent(int entity, const CameraFrame& camera, const Mesh& mesh,
                                         const Pose& pose) {
    if (!camera.depthOf(mesh.bounds, pose))
        return std::nullopt;
    const BoundingSphere& sphere = mesh.sphere;
    const Vec3 centre_m = pose.toWorld(sphere.centre_m);
    const Sensor& sensor = camera.sensor();
    ImageRectangle extent{0.0, 0.0, static_cast<double>(sensor.width_px),
                          static_cast<double>(sensor.height_px)};
    if (const auto ofBox = camera.extentOf(mesh.bounds, pose))
        extent = extent.intersectedWith(*ofBox);
    if (const auto ofSphere = camera.extentOfSphere(centre_m, sphere.radius_m))
        extent = extent.intersectedWith(*ofSphere);
    if (extent.empty())
        return std::nullopt;
    return ObjectExtent{entity, extent, centre_m, sphere.radius_m};
}

} // namespace irsg
