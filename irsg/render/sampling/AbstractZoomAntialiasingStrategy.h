#pragma once

#include <string>
#include <utility>
#include <vector>

#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/sampling/RttPass.h"
#include "irsg/render/sampling/SampleWindow.h"
#include "irsg/render/sampling/ZoomEntityInfo.h"

namespace irsg {

/// What was sampled in one go, for people to see: samples are counted per pixel of the frame.
struct DrawnWindow {
    ImageRectangle rectangle;
    double across = 1.0, down = 1.0;
    std::vector<int> entities;

    static DrawnWindow of(const SampleWindow& window);
    static std::vector<DrawnWindow> of(const std::vector<SampleWindow>& windows);
};

/// How the objects of a frame are sampled.
class AbstractZoomAntialiasingStrategy {
  public:
    virtual ~AbstractZoomAntialiasingStrategy() = default;

    /// Windows that hold every object. Objects whose extents overlap share windows; the parts that
    /// windows leave out to finer ones make every point of an object's extent drawn exactly once.
    virtual std::vector<SampleWindow> windows(const std::vector<ZoomEntityInfo>& objects) const = 0;

    /// The same where nothing but sums over all pixels is asked for.
    virtual std::vector<SampleWindow>
    windowsOfSums(const std::vector<ZoomEntityInfo>& objects) const {
        return windows(objects);
    }

    /// Draws the objects into the pixels of a frame: those windows, unless the strategy has a way
    /// of its own.
    virtual FrameReduction draw(const CameraFrame& camera,
                                const std::vector<ZoomEntityInfo>& objects, RttPass& pass);

    /// What the user should know of the drawings since the last call.
    virtual std::vector<std::string> takeMessages() { return {}; }

    /// Of the last drawing, coarse before fine.
    std::vector<DrawnWindow> takeWindows() { return std::exchange(drawn_, {}); }

  protected:
    std::vector<DrawnWindow> drawn_;

  private:
    RadianceSamples samples_; // room for those of the next drawing
};

/// The windows in pieces that fit a drawing.
std::vector<SampleWindow> piecesOf(const std::vector<SampleWindow>& windows, int largestSide);

} // namespace irsg
