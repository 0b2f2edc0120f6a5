#pragma once

#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/CameraFrame.h"
#include "irsg/scene/SceneRadiometry.h"
#include "irsg/scene/SurfacePass.h"

namespace irsg {

/// Adds what is known of every pixel to its image, as channels:
///   temperature_index, material_index, range [m]  of the nearest surface at the pixel's middle
///   sample,
///                                                 NaN where there is none;
///   thermal, sun, up, down, path, background      terms of the pixel's radiance [W m-2 sr-1],
///   averaged
///                                                 over its samples; their sum is the pixel.
class TruthLayers {
  public:
    /// `image` must outlive this and have the size of the sensor.
    TruthLayers(const SceneRadiometry& radiometry, RadianceImage& image);

    /// Samples with the distances of their opaque surfaces.
    void add(const PixelWindow& window, int samplesPerAxis, const FactorSamples& samples);

  private:
    struct Terms {
        double thermal = 0, up = 0, down = 0, sun = 0, path = 0, transmissivity = 0;
    };

    std::vector<Terms> rows_;
    std::vector<IrCodes> codes_;
    double background_W_m2_sr_;
    RadianceImage& image_;
};

} // namespace irsg
