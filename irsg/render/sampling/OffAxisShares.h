#pragma once

#include <cmath>
#include <cstddef>

#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// What samples of a tile count beside the others of their pixel: an object that is smaller than a
/// pixel and stands off its centre has the solid angle and the cosine of its own place
/// (docs/axes.md, Sensor).
/// Near the axis all count alike, and nothing is computed.
class OffAxisShares {
  public:
    /// Both must live as long.
    OffAxisShares(const SampleTile& tile, const PixelGrid& grid) : tile_(tile), grid_(grid) {
        const PixelRegion pixels = tile.pixels();
        for (const int x : {pixels.x, pixels.x + pixels.width - 1})
            for (const int y : {pixels.y, pixels.y + pixels.height - 1})
                areUnequal_ = areUnequal_ || grid.hasUnequalShares(x, y);
    }

    /// Whether samples of a pixel count differently.
    bool areUnequalIn(int x, int y) const { return areUnequal_ && grid_.hasUnequalShares(x, y); }

    /// Of a sample of the drawing, which lies in a pixel; `isOfGroup`: of the two by two samples
    /// that it stands for.
    PixelGrid::Share of(std::size_t sample, int x, int y, bool isOfGroup = false) const {
        const int row = tile_.rowOf(sample);
        const int column = static_cast<int>(sample - tile_.firstSampleOf(row));
        return grid_.shareAt(
            x, y, place_px(tile_.blockX, column, tile_.samplesAcross, isOfGroup) - x - 0.5,
            place_px(tile_.blockY, row, tile_.samplesDown, isOfGroup) - y - 0.5);
    }

    /// SampleTile::forEachRun with weights that hold this: visit(first, count, x, y, weight, the
    /// same of the projected solid angle).
    template <typename Visit>
    void forEachRun(int firstRow, int lastRow, const Visit& visit) const {
        tile_.forEachRun(
            firstRow, lastRow,
            [&](std::size_t first, int count, int x, int y, double weight)
                __attribute__((always_inline)) {
                    if (!areUnequalIn(x, y))
                        return visit(first, count, x, y, weight, weight);
                    for (int s = 0; s < count; ++s) {
                        const std::size_t sample = first + static_cast<std::size_t>(s);
                        const PixelGrid::Share share = of(sample, x, y);
                        visit(sample, 1, x, y, weight * share.solidAngle, weight * share.projected);
                    }
                });
    }

  private:
    /// The middle of the cell of a sample, or of a pair of them, along one axis of the frame.
    double place_px(std::int64_t firstBlock, int number, int samplesOfBlock, bool isOfGroup) const {
        const int block = number / samplesOfBlock, within = number % samplesOfBlock;
        const double middle = isOfGroup ? within - within % 2 + 1.0 : within + 0.5;
        return std::ldexp(static_cast<double>(firstBlock + block) + middle / samplesOfBlock,
                          -tile_.level);
    }

    const SampleTile& tile_;
    const PixelGrid& grid_;
    bool areUnequal_ = false;
};

} // namespace irsg
