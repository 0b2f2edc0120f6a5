#pragma once

#include <memory>

#include "irsg/render/background/TerrainPainter.h"

namespace irsg {

/// Draws terrains with OpenGL. Lives on the context's thread.
class TerrainPass {
  public:
    static constexpr int samplesPerAxis = TerrainPainter::samplesPerAxis;

    TerrainPass();
    ~TerrainPass();

    TerrainImage draw(const std::shared_ptr<const Terrain>& terrain, const CameraFrame& camera,
                      double offset);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same from any thread.
class GlTerrain : public TerrainPainter {
  public:
    ~GlTerrain() override;
    TerrainImage paint(const std::shared_ptr<const Terrain>& terrain, const CameraFrame& camera,
                       double offset) override;

  private:
    std::unique_ptr<TerrainPass> pass_; ///< made and destroyed on the context's thread
};

} // namespace irsg
