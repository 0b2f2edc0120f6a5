#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/scene/EngineCost.h"
#include "irsg/scene/FrameEngine.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

/// The engines of a renderer, each made when it is first needed, and the choice between them.
class SampleEngines {
  public:
    /// All must live as long.
    SampleEngines(PreparedEntities& prepared, TerrainRays& terrainRays, StageClock& clock)
        : prepared_(prepared), terrainRays_(terrainRays), clock_(clock) {}

    /// The engine of a frame: what the settings ask for, or the quicker one. Throws InputError
    /// where this machine or this build has not got it. `geometry`: by entity.
    FrameEngine of(const FrameRequest& request, const std::vector<ObjectGeometry>& geometry);

    /// Who samples a scene: what was chosen last, where the choice is automatic and there was one.
    std::string description(const Scene& scene);
    std::size_t graphicsMemory_bytes() const { return opengl_ ? opengl_->bytes() : 0; }

  private:
    struct Choice {
        EngineChoice engine = EngineChoice::opengl;
        std::string why; ///< of an automatic choice
    };
    SampleEngine& engineOf(EngineChoice engine);
    /// `geometry`: by entity; none where only the scene is known, whose objects fill the frame
    /// then.
    Choice choose(const Scene& scene, const Sensor& sensor,
                  const std::vector<ObjectGeometry>& geometry);
    EngineWork workOf(const Scene& scene, const Sensor& sensor,
                      const std::vector<ObjectGeometry>& geometry);
    std::string descriptionOf(const Choice& choice);
    TerrainPainter& terrainPainter(EngineChoice engine);

    PreparedEntities& prepared_;
    TerrainRays& terrainRays_;
    StageClock& clock_;
    std::unique_ptr<SampleEngine> opengl_, rays_;
    std::unique_ptr<TerrainPainter> glTerrain_;
    std::string lastChosen_; // of automatic choices
};

} // namespace irsg
