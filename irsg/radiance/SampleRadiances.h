#pragma once

#include "irsg/radiance/Fronts.h"
#include "irsg/radiance/KindRadiances.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Samples as premultiplied radiance and opacity: what lies in front of a surface lets its light
/// through node by node.
class SampleRadiances {
  public:
    /// `light`: between surfaces, or null.
    SampleRadiances(const SurfaceRows& rows, Fronts& fronts, KindRadiances& radiances,
                    SceneLight* light);
    /// Goes through the samples once where kinds of surfaces are known already, else twice.
    void evaluate(const FactorSamples& samples, RadianceSamples& result);

  private:
    const SurfaceRows& rows_;
    Fronts& fronts_;
    KindRadiances& radiances_;
    SceneLight* light_;
};

} // namespace irsg
