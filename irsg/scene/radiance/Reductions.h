#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/scene/RenderReport.h"
#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/KindRadiances.h"
#include "irsg/scene/radiance/ViewFactors.h"
#include "irsg/scene/sampling/FrameReduction.h"

namespace irsg {

/// What each object of a view sends in one output of a sampling, and their sum. Names, ranges and
/// everything that does not come from factors are left alone.
struct ObjectSums {
    std::vector<ObjectRadiometry> objects; ///< by entity
    ObjectRadiometry all;                  ///< sums over them, each at its own range
};

/// Radiometry of the objects of a view, in each output. `ranges_m`: by entity, sensor to reference
/// point. `varying`: by output, the number of its background in the view's layout, or -1 for one
/// that is uniform; what objects hide of a background that varies over the frame is the sum over
/// their own pixels.
std::vector<ObjectSums> objectSums(const ViewFactors& view, KindRadiances& radiances,
                                   const SurfaceRows& rows, const std::vector<double>& ranges_m,
                                   const std::vector<int>& varying);

/// Samples as premultiplied radiance and opacity: what lies in front of a surface lets its light
/// through node by node.
class SampleRadiances {
  public:
    SampleRadiances(const SurfaceRows& rows, Fronts& fronts, KindRadiances& radiances);
    void evaluate(const FactorSamples& samples, RadianceSamples& result);

  private:
    const SurfaceRows& rows_;
    Fronts& fronts_;
    KindRadiances& radiances_;
};

/// Adds the pixels of a view to a frame.
void addPixels(const FactorField<float>& pixels, int width_px, KindRadiances& radiances,
               FrameReduction& frame);

/// Adds a point source of unit distance (see addPointToView) to its pixel.
void addPointToPixel(const FactorField<double>& atUnitDistance_sr_m2, const SurfaceRows& rows,
                     const PointPlace& place, KindRadiances& radiances, FrameReduction& frame);

} // namespace irsg
