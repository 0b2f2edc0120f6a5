#pragma once

#include "irsg/scene/antialiasing/AbstractZoomAntialiasingStrategy.h"
#include "irsg/scene/antialiasing/EntityGroups.h"

namespace irsg {

/// Zoom antialiasing on the sensor's own pixel grid (docs/architecture.md, decision 2): the samples
/// of a window of given size are spent on the object alone, however small it is, and add to pixels
/// one to one.
///
/// A large object is drawn on whole pixels, each sampled as often as the window's size allows and
/// at least twice an axis. A small one is drawn on tiles of a power of two, eight to seventeen of
/// them along its longer side, which lie close around it. Objects that overlap share a window, with
/// depth; one that is much smaller than its group has finer windows cut out for itself, in which
/// the others stand before and behind it.
class PixelAlignedStrategy : public AbstractZoomAntialiasingStrategy {
  public:
    /// Side of a window, samples: 128, 256 or 512 for modes 3 to 5; any from 8.
    explicit PixelAlignedStrategy(int size) : size_(size) {}

    std::vector<SampleWindow> windows(const std::vector<ZoomEntityInfo>& objects) const override;

    static constexpr int fewestSamplesPerAxis = 2;

  private:
    std::vector<SampleWindow> windowsOf(const EntityGroup& group) const;
    void addRefinements(const ZoomEntityInfo& member, double density,
                        std::vector<SampleWindow>& windows) const;

    int size_;
};

} // namespace irsg
