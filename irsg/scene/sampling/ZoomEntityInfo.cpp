#include "irsg/scene/sampling/ZoomEntityInfo.h"

namespace irsg {

std::optional<ZoomEntityInfo> zoomEntityInfo(int entity, const CameraFrame& camera,
                                             const BoundingBox& box, const BoundingSphere& ball,
                                             const Pose& pose) {
    if (!camera.depthOf(box, pose))
        return std::nullopt;
    const Vec3 centre_m = pose.toWorld(ball.centre_m);
    const Sensor& sensor = camera.sensor();
    ImageRectangle extent{0.0, 0.0, static_cast<double>(sensor.width_px),
                          static_cast<double>(sensor.height_px)};
    if (const auto ofBox = camera.extentOf(box, pose))
        extent = extent.intersectedWith(*ofBox);
    if (const auto ofBall = camera.extentOfBall(centre_m, ball.radius_m))
        extent = extent.intersectedWith(*ofBall);
    if (extent.empty())
        return std::nullopt;
    return ZoomEntityInfo{entity, extent, centre_m, ball.radius_m};
}

} // namespace irsg
