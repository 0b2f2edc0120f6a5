#include "irsg/render/sampling/SmoothShares.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "irsg/core/ParallelFor.h"
#include "irsg/render/sampling/JoinedSamples.h"

namespace irsg {

namespace {

/// A sample of a row or column of a block, along that, cells.
struct Along {
    double covered = 0.0; ///< of its cell
    double middle = 0.0;  ///< of what is covered
    double place = 0.0;   ///< of the sample
};

/// The part of a cell between two places, all in cells.
Along cellBetween(int number, double from, double to, double place) {
    const double low = std::max(static_cast<double>(number), from);
    const double high = std::min(number + 1.0, to);
    return {std::max(high - low, 0.0), 0.5 * (low + high), place};
}

/// Calls share(i, s) with what each sample counts: linear in its place, of mean 1, not below 0, and
/// such that sum of covered s place = sum of covered middle, as far as that allows.
template <typename Share>
void shareOut(const std::vector<Along>& all, const Share& share) {
    double sum = 0.0, ofPlaces = 0.0, ofMiddles = 0.0;
    for (const Along& one : all) {
        sum += one.covered;
        ofPlaces += one.covered * one.place;
        ofMiddles += one.covered * one.middle;
    }
    if (sum == 0.0)
        return;
    const double mean = ofPlaces / sum;
    double squares = 0.0, least = 0.0, greatest = 0.0;
    for (const Along& one : all) {
        if (one.covered == 0.0)
            continue;
        squares += one.covered * (one.place - mean) * (one.place - mean);
        least = std::min(least, one.place - mean);
        greatest = std::max(greatest, one.place - mean);
    }
    constexpr double fewest = 1e-6; // of one sample alone, but for rounding
    if (squares < fewest)
        return;
    const double slope =
        std::clamp((ofMiddles - ofPlaces) / squares, -1.0 / greatest, -1.0 / least);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].covered > 0.0)
            share(i, 1.0 + slope * (all[i].place - mean));
}

/// The same of so few samples beside each other, two or three, that gas is smooth over them: of
/// `drawn` ones in their order, each of which is `along(number)`.
template <typename AlongOf, typename Share>
void shareOutFew(const std::vector<int>& drawn, const AlongOf& along, const Share& share) {
    std::vector<Along> few;
    for (std::size_t begin = 0; begin < drawn.size();) {
        const std::size_t end = drawn.size() - begin <= 3 ? drawn.size() : begin + 2;
        few.clear();
        for (std::size_t i = begin; i < end; ++i)
            few.push_back(along(drawn[i]));
        shareOut(few, [&](std::size_t i, double own) { share(drawn[begin + i], own); });
        begin = end;
    }
}

/// The samples of one row of blocks of a tile.
class RowOfBlocks {
  public:
    RowOfBlocks(const SampleTile& tile, int number)
        : tile_(tile),
          firstRow_(number * tile.samplesDown),
          cells_(tile.blocksWide * tile.samplesAcross),
          shares_(static_cast<std::size_t>(cells_ * tile.samplesDown), 1.0) {
        const ImageRectangle all = tile.rectangle(), region = tile.region();
        const auto right = [&](double x_px) { return (x_px - all.left) / tile.cellWidth_px(); };
        const auto down = [&](double y_px) { return (y_px - all.top) / tile.cellHeight_px(); };
        for (int row = 0; row < tile.samplesDown; ++row)
            isDrawn_.push_back(tile.weightsOf(firstRow_ + row));
        const auto alongRow = [&](int cell, int row) {
            return cellBetween(cell, right(region.left), right(region.right),
                               right(placeOf(cell, row).first));
        };
        const auto alongColumn = [&](int cell, int row) {
            return cellBetween(firstRow_ + row, down(region.top), down(region.bottom),
                               down(placeOf(cell, row).second));
        };
        std::vector<int> drawn;
        for (int row = 0; row < tile.samplesDown; ++row)
            forEachStretch(row, [&](int begin, int end) {
                drawn.clear();
                for (int cell = begin; cell < end; ++cell)
                    if (isDrawn(cell, row))
                        drawn.push_back(cell);
                shareOutFew(
                    drawn, [&](int cell) { return alongRow(cell, row); },
                    [&](int cell, double share) { at(cell, row) += share - 1.0; });
            });
        for (int cell = 0; cell < cells_; ++cell) {
            drawn.clear();
            for (int row = 0; row < tile.samplesDown; ++row)
                if (isDrawn(cell, row))
                    drawn.push_back(row);
            shareOutFew(
                drawn, [&](int row) { return alongColumn(cell, row); },
                [&](int row, double share) { at(cell, row) += share - 1.0; });
        }
    }

    void writeTo(std::vector<float>& shares) {
        for (int row = 0; row < tile_.samplesDown; ++row) {
            const std::size_t first = tile_.firstSampleOf(firstRow_ + row);
            for (int cell = 0; cell < cells_; ++cell)
                shares[first + static_cast<std::size_t>(cell)] = static_cast<float>(at(cell, row));
        }
    }
    /// What one counts that stands for a group, whose shares are written.
    void join(GeometrySamples& samples) const {
        for (int row = 0; row < tile_.samplesDown; ++row) {
            const std::size_t first = tile_.firstSampleOf(firstRow_ + row);
            for (std::size_t i = first; i < first + static_cast<std::size_t>(cells_); ++i) {
                if (!samples.standsForGroup(i))
                    continue;
                double sum = 0.0;
                for (const std::size_t member : samples.groupOf(i, tile_.stride()))
                    sum += shareIn(member, row);
                samples.gasShares[i] =
                    static_cast<float>(sum / static_cast<double>(GeometrySamples::samplesOfGroup));
            }
        }
    }

  private:
    std::pair<double, double> placeOf(int cell, int row) const {
        const int ofTile = firstRow_ + row;
        return tile_.placeOf(tile_.firstColumn(ofTile) + cell, ofTile);
    }
    std::size_t indexOf(int cell, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) +
               static_cast<std::size_t>(cell);
    }
    double& at(int cell, int row) { return shares_[indexOf(cell, row)]; }
    /// Of a member of a group of which one is in a row of the blocks.
    double shareIn(std::size_t sample, int near) const {
        for (int row = std::max(near - 1, 0); row < std::min(near + 2, tile_.samplesDown); ++row) {
            const std::size_t first = tile_.firstSampleOf(firstRow_ + row);
            if (sample >= first && sample < first + static_cast<std::size_t>(cells_))
                return shares_[indexOf(static_cast<int>(sample - first), row)];
        }
        return 1.0;
    }
    /// Calls visit(begin, end) for the cells of a row block by block. A cell that is drawn alone of
    /// its block is one with the next block of its pixel: it can't be shared out by itself.
    template <typename Visit>
    void forEachStretch(int row, const Visit& visit) const {
        const int across = tile_.samplesAcross;
        const auto drawnOf = [&](int block) {
            int count = 0;
            for (int i = 0; block < tile_.blocksWide && i < across; ++i)
                count += isDrawn(block * across + i, row);
            return count;
        };
        // Of the next block, where it is of the same pixel.
        const auto drawnNextTo = [&](int block) {
            const auto pixelOf = [&](int one) { return (tile_.blockX + one) >> tile_.level; };
            return pixelOf(block) == pixelOf(block + 1) ? drawnOf(block + 1) : 0;
        };
        int begin = 0, drawn = 0;
        for (int block = 0; block < tile_.blocksWide; ++block) {
            drawn += drawnOf(block);
            const int next = drawnNextTo(block);
            const bool isNextAlone = next == 1 && drawnNextTo(block + 1) == 0;
            if (drawn > 0 && next > 0 && (drawn == 1 || isNextAlone))
                continue;
            visit(begin * across, (block + 1) * across);
            begin = block + 1;
            drawn = 0;
        }
    }
    bool isDrawn(int cell, int row) const {
        return isDrawn_[static_cast<std::size_t>(row)][static_cast<std::size_t>(cell)] > 0.0;
    }

    const SampleTile& tile_;
    int firstRow_, cells_;
    std::vector<double> shares_;               ///< by row and cell
    std::vector<std::vector<double>> isDrawn_; ///< by row: weights
};

} // namespace

void shareOutGas(const SampleSheet& sheet, GeometrySamples& samples) {
    samples.gasShares.clear();
    for (const SampleTile& tile : sheet.tiles) {
        if (tile.isWhole() || (tile.shearRows == 0 && tile.fall == 0))
            continue;
        samples.gasShares.resize(samples.size(), 1.0f);
        parallelFor(partsOfTile, [&](std::size_t part) {
            const auto rows = static_cast<std::size_t>(tile.blocksHigh);
            const std::size_t end = beginOfPart(part + 1, partsOfTile, rows);
            for (std::size_t row = beginOfPart(part, partsOfTile, rows); row < end; ++row) {
                RowOfBlocks blocks(tile, static_cast<int>(row));
                blocks.writeTo(samples.gasShares);
                if (!samples.groups.empty())
                    blocks.join(samples);
            }
        });
    }
}

} // namespace irsg
