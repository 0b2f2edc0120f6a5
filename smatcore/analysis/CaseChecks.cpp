#include "smatcore/analysis/CaseChecks.h"

#include <algorithm>
#include <cmath>

#include "irsg/signature/ClampedTables.h"

namespace smat {

std::vector<std::string> clampedTableWarnings(const irsg::Entity& entity, irsg::EntityState state,
                                              const irsg::Pose& pose,
                                              const irsg::Vec3& referencePoint,
                                              const irsg::Vec3& camera) {
    if (!entity.database)
        return {};
    state.altitude_m = referencePoint.z;
    const irsg::Vec3 toCamera = camera - referencePoint;
    const double range_m = irsg::length(toCamera);
    if (range_m > 0.0) {
        const irsg::Vec3 nose = pose.attitude.rotation() * irsg::Vec3{0, 1, 0};
        state.aspectAngle_rad =
            std::acos(std::clamp(irsg::dot(nose, toCamera) / range_m, -1.0, 1.0));
    }
    std::vector<std::string> sentences;
    for (const std::string& table : irsg::clampedTables(*entity.database, state)) {
        sentences.push_back(entity.name + ": the table " + table +
                            " does not reach this state and holds its end value");
    }
    return sentences;
}

bool reachesBeyondFrame(const irsg::Entity& target, const irsg::Pose& pose,
                        const irsg::Viewpoint& viewpoint, const irsg::Sensor& sensor) {
    if (!target.model)
        return false;
    const irsg::BoundingBox& box = target.model->bounds();
    const double halfWidth = 0.5 * sensor.width_px * sensor.pixelPitch();
    const double halfHeight = 0.5 * sensor.height_px * sensor.pixelPitch();
    for (int corner = 0; corner < 8; ++corner) {
        const irsg::Vec3 inModel{(corner & 1) != 0 ? box.max.x : box.min.x,
                                 (corner & 2) != 0 ? box.max.y : box.min.y,
                                 (corner & 4) != 0 ? box.max.z : box.min.z};
        const irsg::Vec3 seen = pose.toWorld(inModel) - viewpoint.position_m;
        const double ahead_m = irsg::dot(seen, viewpoint.forward());
        if (ahead_m <= 0.0 || std::abs(irsg::dot(seen, viewpoint.right)) > halfWidth * ahead_m ||
            std::abs(irsg::dot(seen, viewpoint.up)) > halfHeight * ahead_m) {
            return true;
        }
    }
    return false;
}

} // namespace smat
