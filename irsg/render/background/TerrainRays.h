#pragma once

#include <memory>

#include "irsg/render/background/TerrainPainter.h"

namespace irsg {

class RayMesh;

/// Terrains that rays meet, the last of which is kept.
class TerrainRays : public TerrainPainter {
  public:
    TerrainRays();
    ~TerrainRays() override;

    /// The faces of a terrain in the axes of its pose; its pieces are the parts of its mesh.
    std::shared_ptr<const RayMesh> meshOf(const std::shared_ptr<const Terrain>& terrain);
    /// On all cores.
    TerrainImage paint(const std::shared_ptr<const Terrain>& terrain, const CameraFrame& camera,
                       double offset) override;

  private:
    struct CacheEntry;
    const CacheEntry& keep(const std::shared_ptr<const Terrain>& terrain);
    std::unique_ptr<CacheEntry> cache_;
};

} // namespace irsg
