#pragma once

#include <memory>
#include <vector>

#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/render/background/Terrain.h"

namespace irsg {

/// A terrain as a frame sees it, one value per pixel, top row first.
struct TerrainImage {
    std::vector<double> texel; ///< mean of (texel - offset) where there is terrain, times coverage
    std::vector<double> coverage;     ///< part of the pixel that is terrain, 0 to 1
    std::vector<double> nearness_1_m; ///< mean of 1 / distance from the eye there, times coverage
};

/// Who paints terrains: the texels of the nearest faces at several samples a pixel, textures
/// averaged where their texels are smaller than samples.
class TerrainPainter {
  public:
    static constexpr int samplesPerAxis = 3;

    virtual ~TerrainPainter() = default;
    virtual TerrainImage paint(const std::shared_ptr<const Terrain>& terrain,
                               const CameraFrame& camera, double offset) = 0;
};

} // namespace irsg
