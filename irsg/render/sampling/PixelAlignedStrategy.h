#pragma once

#include "irsg/render/sampling/EntityGroups.h"
#include "irsg/render/sampling/TileSamplingStrategy.h"

namespace irsg {

/// Zoom antialiasing on the sensor's own pixel grid (docs/architecture.md): the samples
/// of a tile of given size are spent on the object alone, however small it is, and add to pixels
/// one to one.
///
/// A large object is drawn on whole pixels, each sampled as often as the tile's size squared
/// allows and at least twice an axis, whatever the shape of its extent. A small or slim one is
/// drawn on blocks of a power of two, at least 16 along its longer side, which lie close around it.
/// Objects that overlap share a tile, with depth. Finer tiles are cut out of it for what is much
/// smaller: members of the group, in which the others stand before and behind them, and the details
/// that an object has.
class PixelAlignedStrategy : public TileSamplingStrategy {
  public:
    /// Side of a tile, samples: 128, 256 or 512 for modes 3 to 5; any from 8.
    explicit PixelAlignedStrategy(int size) : size_(size) {}

    std::vector<SampleTile> tiles(const std::vector<ObjectExtent>& objects) const override;

    /// Of a pixel or block.
    static constexpr int fewestSamplesPerAxis = 2;

  private:
    std::vector<SampleTile> tilesOf(const EntityGroup& group) const;
    /// Samples of a tile.
    double budget() const { return static_cast<double>(size_) * size_; }

    /// A part of a group that is worth samples of its own.
    struct Part {
        ImageRectangle extent;
        double samples;        ///< of its tile
        double finerFrom;      ///< how much finer that must be than the one around it
        double finerAgainFrom; ///< the same of a tile within that one
    };
    std::vector<Part> partsOf(const EntityGroup& group) const;

    /// Cuts at most so many tiles for the parts out of the one at `coarse`, and out of those in
    /// turn.
    void refine(std::vector<SampleTile>& tiles, std::size_t coarse, const std::vector<Part>& parts,
                const std::vector<ImageEdge>& edges, std::size_t most) const;

    /// The tile of an extent for a budget of samples, with sheared and tilted rows.
    SampleTile tileFor(const ImageRectangle& extent, double samples) const;

    int size_;
};

} // namespace irsg
