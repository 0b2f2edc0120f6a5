#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// Where an entity stands and what it does.
struct EntityPlace {
    irsg::Pose pose;
    irsg::EntityState state;
};

/// A view of a scene as the renderer takes it.
struct PlacedCase {
    irsg::Scene scene;
    irsg::SensorView view;
    std::vector<irsg::Vec3> referencePoints_m; ///< by entity, in the world

    /// A sentence for each lookup table of an entity that is clamped to an end value, because its
    /// axis does not reach the state that the entity is seen in.
    std::vector<std::string> clampedTables() const;
    /// Of what is asked for of the view.
    irsg::Rendered render(const RenderDoor& door, const irsg::Outputs& outputs) const {
        return door.render(scene, view, outputs);
    }
};

/// Puts entities and camera where they are: cases of an analysis, steps of a scenario and pictures
/// of a window become a scene and a view here, and nowhere else.
class CasePlacer {
  public:
    CasePlacer(const RenderDoor& door, const SceneDescription& scene);

    /// In model axes, by entity.
    const std::vector<irsg::Vec3>& referencePoints() const { return inModel_; }
    /// Where the entities stand in the scene.
    static std::vector<std::optional<EntityPlace>> placesIn(const SceneDescription& scene);

    /// A case of an analysis. `scene` is the one that this was made of, perhaps calculated in
    /// another way.
    PlacedCase place(const SceneDescription& scene, const AnalysisCase& one) const;
    /// The entities at these places, by their number; those without one are left out.
    PlacedCase place(const SceneDescription& scene,
                     const std::vector<std::optional<EntityPlace>>& places,
                     const irsg::Viewpoint& viewpoint) const;

  private:
    std::vector<irsg::Vec3> inModel_;
};

/// Asks the renderer whether it would calculate each case of a plan. Throws InputError as it does.
void checkCases(const AnalysisPlan& plan, const CasePlacer& placer, const SceneDescription& scene,
                const RenderDoor& door);

} // namespace smat
