#pragma once

#include <string>
#include <utility>
#include <vector>

#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/sampling/ObjectExtent.h"
#include "irsg/render/sampling/RttPass.h"
#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// What was sampled in one go, for people to see: samples are counted per pixel of the frame.
struct RenderedTile {
    ImageRectangle rectangle;
    double across = 1.0, down = 1.0;
    std::vector<int> entities;

    static RenderedTile of(const SampleTile& tile);
    static std::vector<RenderedTile> of(const std::vector<SampleTile>& tiles);
};

/// How the objects of a frame are sampled.
class TileSamplingStrategy {
  public:
    virtual ~TileSamplingStrategy() = default;

    /// Tiles that hold every object. Objects whose extents overlap share tiles; the parts that
    /// tiles leave out to finer ones make every point of an object's extent drawn exactly once.
    /// Pictures and sums over their pixels have the same, so that both are one number.
    virtual std::vector<SampleTile> tiles(const std::vector<ObjectExtent>& objects) const = 0;

    /// Draws the objects into the pixels of a frame: those tiles, unless the strategy has a way
    /// of its own.
    virtual FrameReduction draw(const CameraFrame& camera, const std::vector<ObjectExtent>& objects,
                                RttPass& pass);

    /// What the user should know of the drawings since the last call.
    virtual std::vector<std::string> takeMessages() { return {}; }

    /// Of the last drawing, coarse before fine.
    std::vector<RenderedTile> takeTiles() { return std::exchange(drawn_, {}); }

  protected:
    std::vector<RenderedTile> drawn_;

  private:
    RadianceSamples samples_; // room for those of the next drawing
};

/// The tiles in pieces that fit a drawing.
std::vector<SampleTile> piecesOf(const std::vector<SampleTile>& tiles, int largestSide);

} // namespace irsg
