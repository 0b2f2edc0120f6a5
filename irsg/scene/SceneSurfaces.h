#pragma once

#include <cstddef>
#include <vector>

#include "irsg/geometry/Entity.h"
#include "irsg/render/sampling/SurfaceScene.h"
#include "irsg/scene/EarthHorizon.h"
#include "irsg/scene/FrameEngine.h"
#include "irsg/scene/Scene.h"
#include "irsg/scene/SceneEvaluation.h"
#include "irsg/scene/SurfaceShading.h"

namespace irsg {

/// The surfaces of a scene as they are sampled, by whatever camera. The scene must live as long.
struct SceneSurfaces {
    const Scene& scene;
    FrameEngine engine;
    SceneEvaluation evaluation;
    SurfaceShading shading;
    std::vector<SurfaceItem> items;   ///< entity by entity
    std::vector<GroundBefore> ground; ///< before what the horizon hides

    const Entity& entity(int e) const { return scene.entities[static_cast<std::size_t>(e)]; }
    const SurfaceRows& rows() const { return evaluation.surfaceRows(); }
};

/// The pieces of all entities with the row of each.
std::vector<SurfaceItem> surfaceItems(const std::vector<Entity>& entities, const SurfaceRows& rows);

} // namespace irsg
