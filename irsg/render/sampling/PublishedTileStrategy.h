#pragma once

#include "irsg/render/sampling/DownsamplingPass.h"
#include "irsg/render/sampling/PixelSizeBasedLod.h"
#include "irsg/render/sampling/TileSamplingStrategy.h"

namespace irsg {

/// Zoom antialiasing as published (report section 6), to be compared with: each object is drawn by
/// a camera that looks at its sphere, into a square of `size` samples; averages of 2 x 2 and 4 x 4
/// bring it to the sphere's size in pixels rounded up to a power of two; a square that faces the
/// camera carries it, bilinearly sampled at the middles of the sensor's pixels. Objects lie before
/// one another by the distance of their centres. One that is wider than `size` pixels is drawn as
/// it is.
///
/// Radiance is premultiplied throughout, in place of the report's straight alpha, which loses the
/// energy of small objects. What remains is bilinear sampling: a lopsided object of a few pixels
/// swings by tens of percent with its place among the pixels.
class PublishedTileStrategy : public TileSamplingStrategy {
  public:
    /// 128, 256 or 512, or another power of two from 8.
    explicit PublishedTileStrategy(int size) : size_(size), lod_(size) {}

    /// For factors, which cannot be resampled: the tiles of PixelAlignedStrategy.
    std::vector<SampleTile> tiles(const std::vector<ObjectExtent>& objects) const override;
    FrameReduction draw(const CameraFrame& camera, const std::vector<ObjectExtent>& objects,
                        RttPass& pass) override;
    std::vector<std::string> takeMessages() override { return lod_.takeMessages(); }

  private:
    void renderTexture(const CameraFrame& camera, const ObjectExtent& object, RttPass& pass,
                       FrameReduction& frame);
    void renderAsItIs(const CameraFrame& camera, const ObjectExtent& object, RttPass& pass,
                      FrameReduction& frame);

    int size_;
    PixelSizeBasedLod lod_;
};

/// Bilinear sample of a texture at coordinates from 0 to 1, its edge clamped beyond the outer
/// texels.
std::pair<double, double> bilinear(const ObjectTexture& texture, double u, double v);

} // namespace irsg
