#pragma once

#include <cstddef>
#include <memory>

#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// Draws surfaces into float targets. Opaque ones by depth; transparent ones into a list of
/// fragments that sortLayers sorts per sample, so that their order is exact also where they
/// cross. Lives on the context's thread.
class SurfacePass {
  public:
    SurfacePass();
    ~SurfacePass();

    /// Radiances of rows; LogicError where an item is transparent.
    void renderRadiance(const SheetScene& sheet, RadianceSamples& samples);
    /// Factors of all layers, the transparent ones not sorted yet.
    void sampleGeometry(const SheetScene& sheet, bool withDistance, GeometrySamples& samples);

    /// Memory of the targets and the list, which every drawing shares.
    std::size_t bytes() const;

    /// Seconds spent drawing and reading back since the last call.
    double takeRenderSeconds();
    double takeReadSeconds();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
