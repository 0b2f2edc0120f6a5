#pragma once

#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/geometry/Entity.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/radiance/exchange/BodyLight.h"
#include "irsg/render/rays/RayMesh.h"
#include "irsg/render/sampling/HotSpots.h"

namespace irsg {

/// Where a body is: alone, or with terrain, with the viewer outside of it; with the viewer within
/// its extent; or among others, whose light varies over large facets.
enum class BodyPlace { alone, overTerrain, seenFromWithin, amongOthers };

/// What sampling makes of a model, once.
struct PreparedModel {
    std::shared_ptr<const Model> model;
    HotSpots hotSpots{};
    std::shared_ptr<const RayMesh> rayMesh{}; ///< made when rays are asked for

    const Mesh& mesh() const { return *model->mesh(); }
    const std::shared_ptr<const RayMesh>& forRays();
    /// Of facets, one side each; found when first asked for.
    const std::vector<double>& areasOfPieces_m2();
    std::vector<double> areas_m2{};
    /// What its surfaces see of each other where its pieces are met so, within an error; see
    /// BodyLight.
    std::shared_ptr<const BodyLight> lightBetween(const PieceUses& uses, double error,
                                                  BodyPlace place);
    struct KnownLight {
        PieceUses uses;
        double error;
        BodyPlace place;
        std::shared_ptr<const BodyLight> light;
    };
    RecentlyUsed<KnownLight> light{2};
};

/// Prepared models by their identity, and reference points by what they follow from. Those of the
/// last scene are kept.
class PreparedEntities {
  public:
    /// Prepares what is new and forgets what is no longer in the scene.
    void keep(const std::vector<Entity>& entities);
    /// Of an entity of the scene that was kept last.
    PreparedModel& of(const Entity& entity);
    /// In model axes: the entity's own, or the centre of the box around what lets no light through,
    /// or around all of it.
    Vec3 referencePoint(const Entity& entity);
    /// How far an entity reaches from its reference point at most, m.
    double reach_m(const Entity& entity);
    /// From an entity's reference point, in the world; unit.
    Vec3 towards(const Entity& entity, const Vec3& place_m);
    /// The same in model axes, rounded so that places along one line of sight share it.
    Vec3 lineOfSight(const Entity& entity, const Vec3& place_m);
    /// A camera on such a line, so far from the reference point, whose frame the entity fills; in
    /// all else `like` a sensor.
    CameraFrame cameraAlong(const Entity& entity, const Vec3& lineOfSight, double distance_m,
                            Sensor like);

  private:
    struct Reference {
        std::shared_ptr<const Model> model;
        std::shared_ptr<const SignatureDatabase> database;
        std::optional<int> fallbackMaterial;
        Vec3 point_m;
    };
    static constexpr std::size_t mostReferences = 64;

    std::list<PreparedModel> models_;
    RecentlyUsed<Reference> references_{mostReferences};
};

} // namespace irsg
