#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/sampling/TileSamplingSelector.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/scene/AspectSampler.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/SurfaceSampler.h"
#include "irsg/scene/ViewKey.h"

namespace irsg {

class ViewSampling;

/// The pixels of a picture in the first band, without its background, and how they were sampled.
struct SampledPicture {
    FrameReduction pixels;
    std::vector<SampledTile> tiles;
    std::vector<std::string> warnings;
    int layersLeftOver = 0;
};

/// Samples frames: factors of views, of which sums are made, factors of pixels, and pictures. Keeps
/// the factors of the view that was begun last and of the pixels that were followed last.
class FrameSampler {
  public:
    /// All must live as long.
    FrameSampler(const RadianceTerms& terms, SurfaceSampler& surfaces, AspectSampler& aspects,
                 OccluderStacks& occluderStacks, StageClock& clock);
    ~FrameSampler();

    /// Begins to sample the factors of a view, unless they are known or under way. The frame must
    /// live until the sampling is done.
    std::shared_ptr<ViewSampling> begin(const Frame& frame);
    /// What that gives. Throws what sampling threw.
    const ViewGeometry& factorsOf(const Frame& frame, ViewSampling& sampling);
    const ViewGeometry& factorsOf(const Frame& frame) { return factorsOf(frame, *begin(frame)); }

    /// With the strategy that the settings ask for. `withSums`: the factors of the view will be
    /// asked for; its samples make them as well, where the picture is drawn from factors.
    SampledPicture picture(const Frame& frame, bool withSums);
    /// The same for a tile that follows edits: a sum where the view is that of the last one.
    SampledPicture followedPicture(const Frame& frame, bool withSums);
    /// The tiles of a picture, side by side as they are drawn.
    std::vector<SampleSheet> sheetsOfPicture(const Frame& frame);
    /// What the pixels of a picture take of each surface that is drawn into tiles.
    PixelGeometry pixelFactors(const Frame& frame);
    void addTruthLayers(const Frame& frame, const FrameBackground& background,
                        RadianceImage& image);

  private:
    std::vector<SampleTile> tilesOf(const Frame& frame, const std::vector<ObjectExtent>& objects);
    /// What the factors of a view go into; null where it is the view that was begun last.
    std::shared_ptr<ViewSampling> newSampling(const Frame& frame);

    const RadianceTerms& terms_;
    SurfaceSampler& surfaces_;
    AspectSampler& aspects_;
    OccluderStacks& occluderStacks_;
    StageClock& clock_;
    TileSamplingSelector antialiasing_;
    GeometrySamples pictureFactors_; // room for those of the next picture
    /// The last view of a followed picture, and once it was asked for twice what its pixels are
    /// made of.
    struct {
        std::optional<ViewKey> key;
        std::optional<PixelGeometry> factors;
    } followed_;
    std::shared_ptr<ViewSampling> view_; // last: it waits for what uses all others
};

/// The factors of a view and how far they are.
class ViewSampling {
  public:
    ViewSampling(ViewKey key, const Frame& frame, std::size_t factorCount);
    ~ViewSampling() { wait(); }
    ViewSampling(const ViewSampling&) = delete;
    ViewSampling& operator=(const ViewSampling&) = delete;

    bool isOf(const ViewKey& key, const std::vector<FrameBackground>& varying) const;
    /// Waits until nothing refers to the frame any more that it was begun for.
    void wait() const {
        if (tiles_.valid())
            tiles_.wait();
    }

  private:
    friend class FrameSampler;
    /// What adds the samples of a tile to the factors; it must not outlive this.
    SurfaceSampler::Take take() {
        return [this](const SampleTile& tile, const GeometrySamples& samples) {
            sums_.addToView(tile, samples, factors_);
        };
    }

    ViewKey key_;
    std::vector<FrameBackground> varying_; // backgrounds that vary over the view
    OccluderStacks occluderStacks_;        // of its own, as it is summed on another thread
    GeometrySums sums_;
    SurfaceSampler::Sampling tiles_; // until they were waited for
    ViewGeometry factors_;
    bool isFinished_ = false;    // they have the renderer's numbers of fronts, and all objects
    std::exception_ptr failure_; // of the sampling, for all who share it
};

} // namespace irsg
