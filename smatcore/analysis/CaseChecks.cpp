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

namespace {

/// The pyramid of what a frame shows.
class FramePyramid {
  public:
    FramePyramid(const irsg::Viewpoint& viewpoint, const irsg::Sensor& sensor,
                 const irsg::Pose& pose)
        : viewpoint_(viewpoint),
          pose_(pose),
          halfWidth_(0.5 * sensor.width_px * sensor.pixelPitch()),
          halfHeight_(0.5 * sensor.height_px * sensor.pixelPitch()) {}

    /// A place in model axes.
    bool holds(const irsg::Vec3& place_m) const {
        const irsg::Vec3 seen = pose_.toWorld(place_m) - viewpoint_.position_m;
        const double ahead_m = irsg::dot(seen, viewpoint_.forward());
        return ahead_m > 0.0 &&
               std::abs(irsg::dot(seen, viewpoint_.right)) <= halfWidth_ * ahead_m &&
               std::abs(irsg::dot(seen, viewpoint_.up)) <= halfHeight_ * ahead_m;
    }
    bool holds(const irsg::BoundingBox& box) const {
        for (int corner = 0; corner < 8; ++corner)
            if (!holds(irsg::Vec3{(corner & 1) != 0 ? box.max.x : box.min.x,
                                  (corner & 2) != 0 ? box.max.y : box.min.y,
                                  (corner & 4) != 0 ? box.max.z : box.min.z}))
                return false;
        return true;
    }

  private:
    const irsg::Viewpoint& viewpoint_;
    const irsg::Pose& pose_;
    double halfWidth_, halfHeight_;
};

} // namespace

bool reachesBeyondFrame(const irsg::Entity& target, const irsg::Pose& pose,
                        const irsg::Viewpoint& viewpoint, const irsg::Sensor& sensor) {
    if (!target.model)
        return false;
    const FramePyramid frame(viewpoint, sensor, pose);
    if (frame.holds(target.model->bounds()))
        return false;
    // Boxes are larger than what they hold.
    const irsg::Mesh& mesh = *target.model->mesh();
    return std::ranges::any_of(mesh.pieces, [&](const irsg::Mesh::Piece& piece) {
        return !frame.holds(piece.bounds) &&
               std::ranges::any_of(mesh.trianglesOf(piece), [&](unsigned vertex) {
                   return !frame.holds(irsg::toVec3(mesh.partOf(piece).vertices[vertex]));
               });
    });
}

std::string beyondFrameWarning(const std::string& entity) {
    return entity + " reaches beyond the frame; what lies outside is not in the sums";
}

} // namespace smat
