#pragma once

#include "irsg/render/sampling/AbstractZoomAntialiasingStrategy.h"
#include "irsg/render/sampling/EntityGroups.h"

namespace irsg {

/// Zoom antialiasing on the sensor's own pixel grid (docs/architecture.md): the samples
/// of a window of given size are spent on the object alone, however small it is, and add to pixels
/// one to one.
///
/// A large object is drawn on whole pixels, each sampled as often as the window's size squared
/// allows and at least twice an axis, whatever the shape of its extent. Where only a sum over
/// pixels is asked for, whose error is that of all samples together, a very large one has fewer:
/// down to one a pixel. A small or slim one is drawn on tiles of a power of two, at least 16 along
/// its longer side, which lie close around it. Objects that overlap share a window, with depth.
/// Finer windows are cut out of it for what is much smaller: members of the group, in which the
/// others stand before and behind them, and the details that an object has.
class PixelAlignedStrategy : public AbstractZoomAntialiasingStrategy {
  public:
    /// Side of a window, samples: 128, 256 or 512 for modes 3 to 5; any from 8.
    explicit PixelAlignedStrategy(int size) : size_(size) {}

    std::vector<SampleWindow> windows(const std::vector<ZoomEntityInfo>& objects) const override;

    std::vector<SampleWindow>
    windowsOfSums(const std::vector<ZoomEntityInfo>& objects) const override;

    /// Of a pixel or tile of a picture.
    static constexpr int fewestSamplesPerAxis = 2;

  private:
    std::vector<SampleWindow> windowsOf(const EntityGroup& group) const;
    /// Samples of a window.
    double budget() const { return static_cast<double>(size_) * size_; }

    /// A part of a group that is worth samples of its own.
    struct Part {
        ImageRectangle extent;
        double samples;        ///< of its window
        double finerFrom;      ///< how much finer that must be than the one around it
        double finerAgainFrom; ///< the same of a window within that one
    };
    std::vector<Part> partsOf(const EntityGroup& group) const;

    /// Cuts at most so many windows for the parts out of the one at `coarse`, and out of those in
    /// turn.
    void refine(std::vector<SampleWindow>& windows, std::size_t coarse,
                const std::vector<Part>& parts, const std::vector<ImageEdge>& edges,
                std::size_t most) const;

    /// The window of an extent for a budget of samples, with sheared and tilted rows.
    SampleWindow windowFor(const ImageRectangle& extent, double samples) const;

    int size_;
    bool isOfSums_ = false;
};

} // namespace irsg
