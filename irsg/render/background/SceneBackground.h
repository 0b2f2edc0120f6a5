#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"
#include "irsg/render/background/BackgroundGrid.h"
#include "irsg/render/background/BandSky.h"
#include "irsg/render/background/FieldRays.h"
#include "irsg/render/background/Horizon.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/render/background/TerrainPainter.h"

namespace irsg {

/// What the background consists of.
struct BackgroundSettings {
    bool queriesEnvironment = true; ///< else `uniform_W_m2_sr` everywhere
    double uniform_W_m2_sr = 0.0;   ///< of the line of sight at the field's centre, or a constant
    int rows = 1, columns = 1;      ///< of the grid; 1 x 1 is uniform
    bool sunDisc = false;
    TextureScale skybox, terrain;
};

/// The background's parts before they are added up, each one value per pixel, W m-2 sr-1, top row
/// first; empty where there is no such part.
struct BackgroundLayers {
    std::vector<double> sky;         ///< skybox, with the disc of the sun upon it
    std::vector<double> environment; ///< the grid; where there is terrain, level ground as far away
    std::vector<double> terrain;     ///< times its coverage
    std::vector<double> coverage;    ///< of the terrain, 0 to 1
    /// Mean of 1 / distance of the terrain from the eye, times its coverage.
    std::vector<double> nearness_1_m;
};

struct BackgroundReport {
    long flooredPixels = 0; ///< whose sum was below 0
    std::vector<std::string> providedBy, warnings;
};

/// Draws what is behind the objects (F27 to F33): the skybox, the disc of the sun in its place, the
/// terrain before both, then the environment's background added: that of the line of sight, and
/// where there is terrain that of level ground at its distance, which holds the air on the way to
/// it. All but the terrain follows the eye.
class SceneBackground {
  public:
    /// Null for none.
    void setSkybox(std::shared_ptr<const Skybox> skybox) { skybox_ = std::move(skybox); }
    void setTerrain(std::shared_ptr<const Terrain> terrain) { terrain_ = std::move(terrain); }
    const std::shared_ptr<const Terrain>& terrain() const { return terrain_; }

    /// Throws InputError where no atmosphere answers, and what the painter throws where there is a
    /// terrain.
    FrameBackground draw(const Sensor& sensor, const Viewpoint& viewpoint, const BandSky& sky,
                         const BackgroundSettings& settings, TerrainPainter& painter,
                         BackgroundReport& report);
    /// Of the last drawing.
    const BackgroundLayers& layers() const { return layers_; }
    /// Hands those over.
    BackgroundLayers takeLayers() { return std::exchange(layers_, {}); }

  private:
    void renderSunImage(const FieldRays& rays, const Horizon& horizon, const BandSky& sky,
                        double altitude_m);

    void renderTerrain(const Sensor& sensor, const Viewpoint& viewpoint, const TextureScale& scale,
                       TerrainPainter& painter);

    /// Terrain is ground: what is added to it does not change at the horizon.
    void putGroundBehindTerrain(const BackgroundGrid& lines,
                                const BackgroundGrid::Radiance& radianceAt, const BandSky& sky,
                                double altitude_m);

    std::shared_ptr<const Skybox> skybox_;
    std::shared_ptr<const Terrain> terrain_;
    BackgroundLayers layers_;
};

} // namespace irsg
