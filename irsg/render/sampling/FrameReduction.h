#pragma once

#include <vector>

#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/image/RadianceImage.h"
#include "irsg/render/sampling/SampleTile.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/values/RenderReport.h"

namespace irsg {

/// Reduces samples to pixels by exact averaging of premultiplied radiance and opacity, in double,
/// and sums the radiometry of the objects on their own tiles before anything is rounded to float.
class FrameReduction {
  public:
    /// `tiles`: what will be added, whole or in pieces.
    FrameReduction(const Sensor& sensor, const std::vector<SampleTile>& tiles);

    void add(const SampleTile& tile, const RadianceSamples& samples);
    /// Adds what a point source adds to one pixel; the cosine off the axis is that of the pixel
    /// times `cosineShare`.
    void addPoint(int x, int y, double radiance_W_m2_sr, double opacity, double cosineShare = 1.0);
    /// Lays a premultiplied radiance over what a pixel holds.
    void cover(int x, int y, double radiance_W_m2_sr, double opacity);

    /// Sums over all pixels added, for objects at a range.
    ObjectRadiometry objects(const FrameBackground& background, double range_m) const;
    /// A_pre + L_bg - alpha L_behind of every pixel of the frame.
    RadianceImage compose(const FrameBackground& background) const;

  private:
    /// Pixels that tiles touch together.
    struct Patch {
        PixelRegion pixels;
        // Top row first; what counts by the cosine off the axis beside that of the pixel.
        std::vector<double> radiance, opacity, projectedRadiance, projectedOpacity;

        void makeRoom();
        std::size_t offset(int x, int y) const {
            return static_cast<std::size_t>(y - pixels.y) * static_cast<std::size_t>(pixels.width) +
                   static_cast<std::size_t>(x - pixels.x);
        }
    };
    Patch* find(const PixelRegion& pixels);
    Patch& patchOf(const PixelRegion& pixels);

    Sensor sensor_;
    std::vector<Patch> patches_; // no two share a pixel
};

} // namespace irsg
