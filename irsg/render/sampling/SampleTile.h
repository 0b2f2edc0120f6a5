#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/geometry/view/ImageRectangle.h"

namespace irsg {

/// A piece of the image plane that is drawn in one go. It lies on a grid of square blocks whose
/// side is 2^-level pixels and whose corner is the frame's: a block belongs to exactly one pixel,
/// so that samples are added to pixels and never resampled, also below the size of a pixel
/// (docs/physics.md, Antialiasing).
struct SampleTile {
    int level = 0;                       ///< 0 (blocks are pixels) to deepestLevel
    std::int64_t blockX = 0, blockY = 0; ///< first block
    int blocksWide = 0, blocksHigh = 0;
    int samplesAcross = 1, samplesDown = 1; ///< of each block
    /// Every row of samples is moved to the right of the one above it by 1 / shearRows of a sample,
    /// so that an upright edge does not meet whole columns; 0: none is. Each row still has exactly
    /// `samplesAcross` samples in each block.
    int shearRows = 0;
    /// Samples that a row of them falls from the left end of a drawing to its right end: 1, 0 or
    /// -1. Where rows are tilted a level edge does not meet a whole row; each sample stays inside
    /// its cell.
    int fall = 0;
    std::vector<int> entities; ///< what is drawn into it
    /// Parts that finer tiles draw; they begin and end at cells of this tile.
    std::vector<ImageRectangle> leftOut;
    /// What it draws of its blocks: a sample counts with what of its cell lies inside. None: all.
    std::optional<ImageRectangle> only{};
    /// Where its lower left sample lies in a drawing that other tiles share, and how many samples
    /// a row of that has; 0: the drawing is its own.
    std::size_t firstSample = 0;
    int renderingWidth = 0;

    bool operator==(const SampleTile&) const = default;

    static constexpr int deepestLevel = 40;

    double blockSide_px() const;
    ImageRectangle rectangle() const;
    /// What it draws, with the parts that it leaves to finer tiles.
    ImageRectangle region() const { return only.value_or(rectangle()); }
    /// The smallest rectangle of whole cells of samples that holds a part of the region. Cells lie
    /// side by side whatever the shear, each with its sample inside.
    ImageRectangle cellsAround(const ImageRectangle& part) const;
    double cellWidth_px() const { return blockSide_px() / samplesAcross; }
    double cellHeight_px() const { return blockSide_px() / samplesDown; }
    /// One sample in each pixel of a square frame.
    static SampleTile ofFrame(int side_px, std::vector<int> entities);
    /// The pixels that its blocks belong to.
    PixelRegion pixels() const;
    /// Of its drawing, samples.
    int width() const { return blocksWide * samplesAcross + columnsOfShear(); }
    int height() const { return blocksHigh * samplesDown; }
    /// Puts it into a drawing of other tiles.
    void placeIn(int width, int x, int y) {
        renderingWidth = width;
        firstSample = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x);
    }
    /// Samples from one row of its drawing to the next.
    std::size_t stride() const {
        return static_cast<std::size_t>(renderingWidth > 0 ? renderingWidth : width());
    }
    /// Rectangle of its drawing, which a shear makes wider.
    ImageRectangle renderedRectangle() const;
    /// How far the samples of a row, counted from the top, are moved, samples.
    double shift(int row) const { return shearRows ? static_cast<double>(row) / shearRows : 0.0; }
    /// How far the sample in a column of the drawing is moved down, samples: -1/2 to 1/2.
    double drop(double column) const { return fall * ((column + 0.5) / width() - 0.5); }
    /// Where the sample in a column and a row, counted from the top, of the drawing stands in the
    /// frame, pixels to the right of and below its corner.
    std::pair<double, double> placeOf(int column, int row) const;
    /// What one sample is of a pixel's area.
    double share() const;
    /// Samples per pixel and axis, the coarser of the two axes.
    double density() const;
    /// Whole blocks of at most `side` samples each way.
    std::vector<SampleTile> pieces(int side) const;

    /// Calls visit(first, count, x, y, weight) for every run of samples of one row that fall to
    /// pixel (x, y): `count` samples from index `first` on, in the order of a drawing, bottom row
    /// first, each of which counts with `weight`, above 0 to 1.
    template <typename Visit>
    void forEachRun(const Visit& visit) const {
        forEachRun(0, height(), visit);
    }
    /// The first row of samples, counted from the top, that falls to a row of pixels or below it.
    int firstRowOf(int y) const {
        const std::int64_t block = (static_cast<std::int64_t>(y) << level) - blockY;
        return static_cast<int>(std::clamp<std::int64_t>(block, 0, blocksHigh)) * samplesDown;
    }
    /// The same of the rows from one on to before another, counted from the top.
    template <typename Visit>
    void forEachRun(int firstRow, int lastRow, const Visit& visit) const;

    /// Whether all of its samples count fully.
    bool isWhole() const { return leftOut.empty() && !only; }
    /// Weights of the samples of a row, counted from the top, block by block.
    std::vector<double> weightsOf(int row) const;
    /// The sample of a row, counted from the top, that stands for its first cell.
    std::size_t firstSampleOf(int row) const {
        return firstSample + static_cast<std::size_t>(height() - 1 - row) * stride() +
               static_cast<std::size_t>(firstColumn(row));
    }
    /// The row, counted from the top, of a sample of the drawing.
    int rowOf(std::size_t sample) const {
        return height() - 1 - static_cast<int>((sample - firstSample) / stride());
    }
    /// Where the first sample of a row, counted from the top, stands in that row of its drawing.
    int firstColumn(int row) const { return static_cast<int>(std::ceil(shift(row) - 0.5)); }

  private:
    int columnsOfShear() const { return shearRows ? (height() - 1) / shearRows + 1 : 0; }
};

template <typename Visit>
void SampleTile::forEachRun(int firstRow, int lastRow, const Visit& visit) const {
    for (int row = firstRow; row < lastRow; ++row) {
        const std::vector<double> weights = isWhole() ? std::vector<double>{} : weightsOf(row);
        const int y = static_cast<int>((blockY + row / samplesDown) >> level);
        std::size_t first = firstSampleOf(row);
        for (int block = 0; block < blocksWide;
             ++block, first += static_cast<std::size_t>(samplesAcross)) {
            const int x = static_cast<int>((blockX + block) >> level);
            if (weights.empty()) {
                visit(first, samplesAcross, x, y, 1.0);
                continue;
            }
            const auto* weight =
                &weights[static_cast<std::size_t>(block) * static_cast<std::size_t>(samplesAcross)];
            for (int s = 0; s < samplesAcross;) {
                int end = s + 1;
                while (end < samplesAcross && weight[end] == weight[s])
                    ++end;
                if (weight[s] > 0.0)
                    visit(first + static_cast<std::size_t>(s), end - s, x, y, weight[s]);
                s = end;
            }
        }
    }
}

} // namespace irsg
