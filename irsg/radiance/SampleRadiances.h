#pragma once

#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Samples as premultiplied radiance and opacity: what lies in front of a surface lets its light
/// through node by node.
class SampleRadiances {
  public:
    /// `light`: between surfaces, or null.
    SampleRadiances(const SurfaceRows& rows, OccluderStacks& occluderStacks,
                    SurfaceRadianceTable& radiances, SceneLight* light);
    /// Goes through the samples once where kinds of surfaces are known already, else twice.
    void evaluate(const GeometrySamples& samples, RadianceSamples& result);

  private:
    const SurfaceRows& rows_;
    OccluderStacks& occluderStacks_;
    SurfaceRadianceTable& radiances_;
    SceneLight* light_;
};

} // namespace irsg
