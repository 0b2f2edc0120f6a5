#include "smatcore/analysis/HeldTables.h"

#include <algorithm>
#include <cmath>

namespace smat {

std::vector<std::string> heldTables(const irsg::Entity& entity, irsg::EntityState state,
                                    const irsg::Pose& pose, const irsg::Vec3& referencePoint,
                                    const irsg::Vec3& camera) {
    if (!entity.database) {
        return {};
    }
    state.altitude_m = referencePoint.z;
    const irsg::Vec3 toCamera = camera - referencePoint;
    const double range_m = irsg::length(toCamera);
    if (range_m > 0.0) {
        const irsg::Vec3 nose = pose.attitude.rotation() * irsg::Vec3{0, 1, 0};
        state.aspectAngle_rad =
            std::acos(std::clamp(irsg::dot(nose, toCamera) / range_m, -1.0, 1.0));
    }
    std::vector<std::string> sentences;
    for (const std::string& table : irsg::tablesHeld(*entity.database, state)) {
        sentences.push_back(entity.name + ": the table " + table +
                            " does not reach this state and holds its end value");
    }
    return sentences;
}

} // namespace smat
