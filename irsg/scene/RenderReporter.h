#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/RenderErrorEstimator.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

/// Makes reports of what was sampled: the radiometry of the objects, and who and what it is from.
class RenderReporter {
  public:
    /// Both must live as long.
    RenderReporter(RenderErrorEstimator& errors, StageClock& clock)
        : errors_(errors), clock_(clock) {}

    /// By output, from the factors of a view.
    std::vector<RenderReport> reports(const Frame& frame, const ViewGeometry& factors);
    /// From the spectra of a frame.
    std::vector<RenderReport> reports(const Frame& frame);
    /// What the pixels of a picture of at most one object add up to, in the first band.
    RenderReport report(const Frame& frame, const FrameReduction& pixels,
                        const FrameBackground& background);
    /// Gives a picture its attributes.
    static void describe(const Frame& frame, const FrameBackground& background,
                         RadianceImage& image);

  private:
    /// `errors`: by output, none where nobody asked for them.
    std::vector<RenderReport> reportsOf(const Frame& frame, std::vector<ObjectSums> sums,
                                        const ErrorsByOutput& errors, int layersLeftOver);
    void fill(const Frame& frame, std::size_t output, RenderReport& report);
    double totalIrradiance_W_m2(const Frame& frame, const FrameBackground& background,
                                double contrast_W_m2);
    double projectedSolidAngle_sr(const Sensor& sensor);

    RenderErrorEstimator& errors_;
    StageClock& clock_;
    /// Sum of omega cos(theta) over the frame, of the last raster.
    struct {
        std::array<double, 3> raster{};
        double projected_sr = 0.0;
    } solidAngle_;
};

} // namespace irsg
