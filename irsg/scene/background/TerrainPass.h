#pragma once

#include <memory>
#include <vector>

#include "irsg/scene/background/Terrain.h"
#include "irsg/scene/view/CameraFrame.h"

namespace osg {
class RenderInfo;
}

namespace irsg {

/// A terrain as a frame sees it, one value per pixel, top row first.
struct TerrainImage {
    std::vector<double> texel; ///< mean of (texel - offset) where there is terrain, times coverage
    std::vector<double> coverage; ///< part of the pixel that is terrain, 0 to 1
};

/// Draws terrains: the texels of the nearest faces at several samples a pixel, textures averaged
/// where their texels are smaller than samples. Lives on the context's thread.
class TerrainPass {
  public:
    static constexpr int samplesPerAxis = 3;

    TerrainPass();
    ~TerrainPass();

    TerrainImage draw(osg::RenderInfo& info, const std::shared_ptr<const Terrain>& terrain,
                      const CameraFrame& camera, double offset);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
