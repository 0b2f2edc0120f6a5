#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "irsg/radiance/ViewSurfaceSums.h"
#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// Differences between interleaved lattices of the samples of some rows of a tile. Every second
/// row and every second column of a lattice is a lattice of a quarter of its samples; the four of
/// them are phase-shifted drawings of the same view, and three sums with signs hold all by which
/// they differ:
///
///     rows      sum of (-1)^row f
///     columns   sum of (-1)^column f
///     both      sum of (-1)^(row + column) f
///
/// A border of what is drawn is no edge of the object: samples beside one count half where signs
/// alternate across it, so that a constant f gives 0 and a straight edge half a row of samples
/// whatever its phase.
enum class SublatticeDifference { rows, columns, both };
inline constexpr std::size_t sublatticeDifferenceKinds = 3;

/// Sums of samples as ViewSurfaceSums makes them, with their contrasts.
template <std::size_t Factors>
class SublatticeDifferences {
  public:
    /// A sample counts with those that it stands for.
    static constexpr bool isByPixel = false;
    /// Of the rows from one on to before another, counted from the top. All must live as long.
    SublatticeDifferences(const SampleTile& tile, std::size_t firstRow, std::size_t lastRow,
                          const ViewSurfaceSums<Factors>& empty)
        : tile_(tile),
          firstRow_(static_cast<int>(firstRow)),
          lastRow_(static_cast<int>(lastRow)),
          cells_(static_cast<std::size_t>(tile.blocksWide * tile.samplesAcross)),
          classes_{empty, empty, empty, empty},
          joined_(empty),
          beyond_(empty),
          corrections_{empty, empty, empty} {}

    void goTo(int x, int y, double weight) {
        classes_[0].goTo(x, y, weight);
        for (std::size_t c = 1; c < classes_.size(); ++c)
            classes_[c].goTo(classes_[0], 1.0);
        beyond_.goTo(classes_[0], 1.0);
        joined_.goTo(classes_[0], static_cast<double>(GeometrySamples::samplesOfGroup));
        weight_ = weight;
    }

    /// The next layers are those of a sample of the drawing. Where it stands for a group, one of
    /// each lattice, all have the same of it.
    void at(std::size_t sample, bool isOfGroup) {
        if (isOfGroup) {
            now_ = &joined_;
            isCorrected_ = false;
            return;
        }
        if (sample < rowBegin_ || sample >= rowEnd_)
            goToRow(sample);
        const std::size_t column = sample - rowBegin_, cell = column - firstCell_;
        now_ = &classes_[2 * rowParity_ + column % 2];
        isCorrected_ = false;
        if (!isBorderRow_ && inside_.empty() && cell > 0 && cell + 1 < cells_)
            return;
        const double across = besideInRow(cell), down = besideInColumn(cell);
        if (across == weight_ && down == weight_)
            return;
        isCorrected_ = hasCorrections_ = true;
        const double ofRow = rowParity_ == 0 ? 1.0 : -1.0, ofColumn = column % 2 == 0 ? 1.0 : -1.0;
        const std::array<double, sublatticeDifferenceKinds> wanted = {down, across, across};
        const std::array<double, sublatticeDifferenceKinds> signs = {ofRow, ofColumn,
                                                                     ofRow * ofColumn};
        for (std::size_t k = 0; k < sublatticeDifferenceKinds; ++k)
            corrections_[k].goTo(classes_[0], signs[k] * (wanted[k] / weight_ - 1.0));
    }

    void setShare(const PixelGrid::Share& share) {
        now_->setShare(share);
        beyond_.setShare(share);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.setShare(share);
    }
    void add(int front, const SurfaceRows::Between& between, const GeometrySamples::Layer& layer) {
        now_->add(front, between, layer);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.add(front, between, layer);
    }
    void addLight(int front, const SurfaceRows::Between& between,
                  const GeometrySamples::Layer& layer) {
        now_->addLight(front, between, layer);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.addLight(front, between, layer);
    }

    void addReceived(int front, const SurfaceRows::Between& between,
                     const GeometrySamples::Layer& layer) {
        now_->addReceived(front, between, layer);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.addReceived(front, between, layer);
    }

    /// No sample comes after it.
    void finishLight() {
        for (ViewSurfaceSums<Factors>& sums : classes_)
            sums.finishLight();
        joined_.finishLight();
        for (ViewSurfaceSums<Factors>& sums : corrections_)
            sums.finishLight();
    }
    void addSpecular(int front, const GeometrySamples& samples, const GeometrySamples::Layer& layer,
                     const GeometrySamples::Specular& mirror) {
        now_->addSpecular(front, samples, layer, mirror);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.addSpecular(front, samples, layer, mirror);
    }
    void addGas(int front, const SurfaceRows::Between& between, const GasWalk::Emission& gas) {
        // Shares differ between lattices, which is none of what they differ by.
        if (gas.share != 1.0) {
            GasWalk::Emission plain = gas, more = gas;
            plain.share = 1.0;
            const bool isOfGroup = now_ == &joined_;
            more.share = (gas.share - 1.0) *
                         (isOfGroup ? static_cast<double>(GeometrySamples::samplesOfGroup) : 1.0);
            beyond_.addGas(front, between, more);
            return addGas(front, between, plain);
        }
        now_->addGas(front, between, gas);
        if (isCorrected_)
            for (ViewSurfaceSums<Factors>& sums : corrections_)
                sums.addGas(front, between, gas);
    }
    void finishGas(LayerWalk& walk) {
        for (ViewSurfaceSums<Factors>& sums : classes_)
            sums.finishGas(walk);
        joined_.finishGas(walk);
        beyond_.finishGas(walk);
        for (ViewSurfaceSums<Factors>& sums : corrections_)
            sums.finishGas(walk);
    }
    void finish() {
        for (ViewSurfaceSums<Factors>& sums : classes_)
            sums.finish();
        joined_.finish();
        beyond_.finish();
        for (ViewSurfaceSums<Factors>& sums : corrections_)
            sums.finish();
    }

    /// Calls visit(sums, sign) for what the sum of all is made of.
    template <typename Visit>
    void forEachOfSum(Visit visit) const {
        for (const ViewSurfaceSums<Factors>& sums : classes_)
            visit(sums, 1.0);
        visit(joined_, 1.0);
        visit(beyond_, 1.0);
    }
    /// The same of a contrast.
    template <typename Visit>
    void forEachOf(SublatticeDifference contrast, Visit visit) const {
        for (std::size_t c = 0; c < classes_.size(); ++c) {
            const double ofRow = c / 2 == 0 ? 1.0 : -1.0, ofColumn = c % 2 == 0 ? 1.0 : -1.0;
            visit(classes_[c], contrast == SublatticeDifference::rows      ? ofRow
                               : contrast == SublatticeDifference::columns ? ofColumn
                                                                           : ofRow * ofColumn);
        }
        if (hasCorrections_)
            visit(corrections_[static_cast<std::size_t>(contrast)], 1.0);
    }

  private:
    void goToRow(std::size_t sample) {
        const std::size_t fromBottom = (sample - tile_.firstSample) / tile_.stride();
        const int row = tile_.height() - 1 - static_cast<int>(fromBottom);
        rowBegin_ = tile_.firstSample + fromBottom * tile_.stride();
        rowEnd_ = rowBegin_ + tile_.stride();
        firstCell_ = static_cast<std::size_t>(tile_.firstColumn(row));
        rowParity_ = static_cast<std::size_t>(row % 2);
        isFirst_ = row == firstRow_;
        isLast_ = row + 1 == lastRow_;
        isBorderRow_ = isFirst_ || isLast_;
        if (tile_.isWhole())
            return;
        inside_ = tile_.weightsOf(row);
        above_ = isFirst_ ? std::vector<double>(cells_, 0.0) : tile_.weightsOf(row - 1);
        below_ = isLast_ ? std::vector<double>(cells_, 0.0) : tile_.weightsOf(row + 1);
    }
    bool isInside(const std::vector<double>& weights, std::size_t cell) const {
        constexpr double whole = 1.0 - 1e-9;
        return weights.empty() || weights[cell] >= whole;
    }
    /// 1, 1/2 or 0, by how many of a cell's neighbours are drawn.
    double besideInRow(std::size_t cell) const {
        if (!isInside(inside_, cell))
            return 0.0;
        return (cell > 0 && isInside(inside_, cell - 1) ? 0.5 : 0.0) +
               (cell + 1 < cells_ && isInside(inside_, cell + 1) ? 0.5 : 0.0);
    }
    double besideInColumn(std::size_t cell) const {
        if (!isInside(inside_, cell))
            return 0.0;
        return (!isFirst_ && isInside(above_, cell) ? 0.5 : 0.0) +
               (!isLast_ && isInside(below_, cell) ? 0.5 : 0.0);
    }

    const SampleTile& tile_;
    int firstRow_, lastRow_;
    std::size_t cells_;                               ///< of a row
    std::array<ViewSurfaceSums<Factors>, 4> classes_; ///< by parity of row and column
    ViewSurfaceSums<Factors> joined_;                 ///< groups of one of each class
    ViewSurfaceSums<Factors> beyond_;                 ///< what gas counts more or less in the sum
    std::array<ViewSurfaceSums<Factors>, sublatticeDifferenceKinds> corrections_;
    ViewSurfaceSums<Factors>* now_ = nullptr;
    bool isCorrected_ = false, hasCorrections_ = false;
    // The run and the row of the present sample.
    double weight_ = 0.0;
    std::size_t rowBegin_ = 0, rowEnd_ = 0, firstCell_ = 0, rowParity_ = 0;
    bool isFirst_ = false, isLast_ = false, isBorderRow_ = false;
    std::vector<double> inside_, above_, below_; ///< weights of its cells; empty: all count
};

} // namespace irsg
