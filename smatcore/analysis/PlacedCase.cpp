#include "smatcore/analysis/PlacedCase.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "smatcore/analysis/CaseChecks.h"

namespace smat {

std::vector<std::string> PlacedCase::clampedTables() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const irsg::Entity& entity = scene.entities[i];
        std::vector<std::string> own = clampedTableWarnings(
            entity, entity.state, entity.pose, referencePoints_m[i], view.viewpoint.position_m);
        std::ranges::move(own, std::back_inserter(all));
    }
    return all;
}

CasePlacer::CasePlacer(const RenderDoor& door, const SceneDescription& scene) {
    for (const irsg::Entity& entity : scene.entities) {
        // By way of the world, to the last bit as results have always had it.
        const irsg::Pose& pose = entity.pose;
        const irsg::Vec3 inWorld = pose.toWorld(door.referencePoint(entity));
        inModel_.push_back(pose.attitude.rotation().transposed() * (inWorld - pose.position_m));
    }
}

std::vector<std::optional<EntityPlace>> CasePlacer::placesIn(const SceneDescription& scene) {
    std::vector<std::optional<EntityPlace>> places;
    for (const irsg::Entity& entity : scene.entities)
        places.emplace_back(EntityPlace{entity.pose, entity.state});
    return places;
}

PlacedCase CasePlacer::place(const SceneDescription& scene, const AnalysisCase& one) const {
    std::vector<std::optional<EntityPlace>> places = placesIn(scene);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i]->state = one.state(scene.entities[i].state, scene.ownOf(i));
    const irsg::Pose standing = one.standing(scene.entities.front().pose);
    places.front()->pose = one.pose(standing, inModel_.front());
    return place(scene, places, one.viewpoint(standing.toWorld(inModel_.front())));
}

PlacedCase CasePlacer::place(const SceneDescription& scene,
                             const std::vector<std::optional<EntityPlace>>& places,
                             const irsg::Viewpoint& viewpoint) const {
    PlacedCase placed{scene, {scene.sensor, viewpoint}, {}};
    std::vector<irsg::Entity>& entities = placed.scene.entities;
    std::size_t there = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i])
            continue;
        irsg::Entity& entity = entities[there];
        if (there != i)
            entity = std::move(entities[i]);
        ++there;
        entity.pose = places[i]->pose;
        entity.state = places[i]->state;
        placed.referencePoints_m.push_back(entity.pose.toWorld(inModel_[i]));
    }
    entities.resize(there);
    return placed;
}

void checkCases(const AnalysisPlan& plan, const CasePlacer& placer, const SceneDescription& scene,
                const RenderDoor& door) {
    const irsg::Outputs outputs = plan.kind->form == AnalysisForm::image ? irsg::Outputs::image()
                                  : plan.kind->form == AnalysisForm::spectrum
                                      ? irsg::Outputs::reports()
                                      : irsg::Outputs::reports(scene.allBands());
    for (const AnalysisCase& one : plan.cases) {
        const PlacedCase placed = placer.place(scene, one);
        door.check(placed.scene, placed.view, outputs);
    }
}

} // namespace smat
