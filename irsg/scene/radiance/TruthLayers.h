#pragma once

#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/radiance/SceneRadiometry.h"
#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/FrameBackground.h"

namespace irsg {

/// Adds what is known of every pixel to its image, as channels:
///   temperature_index, material_index, range [m]  of the nearest surface at the sample closest to
///                                                 the pixel's middle among those that hit one,
///                                                 NaN where none does;
///   thermal, sun, up, down, path, background      terms of the pixel's radiance [W m-2 sr-1],
///                                                 averaged over its samples; their sum is the
///                                                 pixel.
class TruthLayers {
  public:
    /// `image` must outlive this and have the size of the sensor.
    TruthLayers(const SceneRadiometry& radiometry, const FrameBackground& background,
                RadianceImage& image);

    /// Samples with the distances of their opaque surfaces.
    void add(const SampleWindow& window, const FactorSamples& samples);

  private:
    struct Terms {
        double thermal = 0, up = 0, down = 0, sun = 0, path = 0, transmissivity = 0;
    };

    std::vector<Terms> rows_;
    std::vector<IrCodes> codes_;
    const FrameBackground& background_;
    RadianceImage& image_;
    std::vector<float> offMiddle_px_; // of the sample whose surface is named, by pixel
};

} // namespace irsg
