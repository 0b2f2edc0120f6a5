#pragma once

#include <string>
#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/image/RadianceImage.h"
#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// Adds what is known of every pixel to its image, as channels:
///   temperature_index, material_index, object_index (where there are several objects), range [m]
///                                                  of the nearest surface at the sample closest to
///                                                 the pixel's middle among those that hit one,
///                                                 NaN where none does;
///   a channel for each RadianceTerm (mirror where surfaces have lobes), inter_reflection (where
///   surfaces light each other), background                                    terms of the pixel's
///   radiance [W m-2 sr-1],
///                                                 averaged over its samples; their sum is the
///                                                 pixel;
///   sun_visibility, sky_visibility                part of the sun, and of the hemisphere, that the
///                                                 nearest surface sees, of the latter as far as
///                                                 sky or ground are there.
class TruthLayers {
  public:
    /// `image` must outlive this and have the size of the sensor, the others must live as long.
    /// `light`: between surfaces, or null.
    TruthLayers(const Sensor& sensor, const SceneRadiometry& radiometry,
                SurfaceRadianceTable& radiances, OccluderStacks& occluderStacks,
                const FrameBackground& background, SceneLight* light, RadianceImage& image);

    /// Samples with the distances of their opaque surfaces.
    void add(const SampleTile& tile, const GeometrySamples& samples);

  private:
    struct SurfaceStackTerms {
        std::vector<double> terms;
        double opacity = 0.0;
        const std::vector<SceneLight::AtReceiver>* light = nullptr;
    };
    const SurfaceStackTerms& termsOf(const SurfaceStackId& kind);

    PixelGrid grid_;
    const SceneRadiometry& radiometry_;
    SurfaceRadianceTable& radiances_;
    OccluderStacks& occluderStacks_;
    const FrameBackground& background_;
    SceneLight* light_;
    RadianceImage& image_;
    LayerWalk walk_;
    GeometryBuffer<double> kinds_;         // for its numbers of the walk's kinds alone
    std::vector<SurfaceStackTerms> terms_; // by number
    std::vector<std::size_t> shown_;       // terms that have a channel
    bool hasObjects_ = false;
    std::vector<float> offMiddle_px_; // of the sample whose surface is named, by pixel
};

} // namespace irsg
