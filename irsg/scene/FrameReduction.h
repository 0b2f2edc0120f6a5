#pragma once

#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/CameraFrame.h"
#include "irsg/scene/Irsg.h"
#include "irsg/scene/SurfacePass.h"

namespace irsg {

/// Reduces samples to pixels by exact averaging of premultiplied radiance and opacity, in double,
/// and sums the radiometry of the objects on their own window before anything is rounded to float.
class FrameReduction {
  public:
    /// `window`: the pixels that will be added; `background`: uniform, W m-2 sr-1.
    FrameReduction(const Sensor& sensor, const PixelWindow& window, double background_W_m2_sr);

    void add(const PixelWindow& tile, int samplesPerAxis, const RadianceSamples& samples);

    /// Sums over all pixels added, for objects at a range.
    ObjectRadiometry objects(double range_m) const;
    /// A_pre + (1 - alpha) L_bg of every pixel of the frame.
    RadianceImage compose() const;

  private:
    Sensor sensor_;
    PixelWindow window_;
    double background_W_m2_sr_;
    std::vector<double> radiance_, opacity_; // of the window's pixels, top row first
};

} // namespace irsg
