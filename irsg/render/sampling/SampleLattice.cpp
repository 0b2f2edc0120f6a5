#include "irsg/render/sampling/SampleLattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// (sin(pi x) / (pi x))^2, beyond the first zero its mean over a period.
double squareOfSinc(double x) {
    const double square = pi * pi * x * x;
    if (square < 1e-12)
        return 1.0;
    if (std::abs(x) > 1.0)
        return 0.5 / square;
    const double sine = std::sin(pi * x);
    return sine * sine / square;
}

/// Frequencies of the dual lattice, whole numbers along its two directions: (m, l) stands for
/// (m / cell width, (l + m / shearRows) / cell height) where rows are not tilted. `lean`: how far a
/// row is moved against the one above it, `fall`: a sample against the one left of it, samples.
struct DualLattice {
    double perWidth, perHeight, lean, fall;

    explicit DualLattice(const SampleTile& tile)
        : perWidth(1.0 / tile.cellWidth_px()),
          perHeight(1.0 / tile.cellHeight_px()),
          lean(tile.shearRows ? 1.0 / tile.shearRows : 0.0),
          fall(tile.drop(1.0) - tile.drop(0.0)) {}

    double right(double m, double l) const { return (m - l * fall) / area() * perWidth; }
    double down(double m, double l) const { return (l + m * lean) / area() * perHeight; }

  private:
    /// Of a cell, in terms of one that is neither sheared nor tilted.
    double area() const { return 1.0 + fall * lean; }
};

double wholeNumberNear(double x) {
    return static_cast<double>(static_cast<long>(x < 0.0 ? x - 0.5 : x + 0.5));
}

double squareOfOne(const ImageEdge& edge, double right, double down) {
    const double across = edge.right_px * down - edge.down_px * right;
    const double along = edge.right_px * right + edge.down_px * down;
    const double amplitude = across / (2.0 * pi * (right * right + down * down));
    return edge.count * amplitude * amplitude * squareOfSinc(along);
}

double varianceOf(const ImageEdge& edge, const DualLattice& dual) {
    constexpr int rows = 24; // beyond, their share is small: it falls with the frequency squared
    // In steps along the lattice: across its rows, and along them.
    const double cellsRight = edge.right_px * dual.perWidth;
    const double cellsDown = edge.down_px * dual.perHeight;
    const double across = cellsDown - dual.fall * cellsRight;
    const double along = cellsRight + dual.lean * cellsDown;
    const bool isSteep = std::abs(cellsDown) > std::abs(cellsRight);
    const double slope = isSteep ? along / across : across / along;
    double sum = 0.0;
    for (int i = 1; i <= rows; ++i) {
        // The frequency nearest across the edge: m along + l across near 0.
        double m = i, l = i;
        if (isSteep)
            l = wholeNumberNear(-i * slope);
        else
            m = wholeNumberNear(-i * slope);
        sum += 2.0 * squareOfOne(edge, dual.right(m, l), dual.down(m, l));
    }
    return sum;
}

} // namespace

double varianceOfEdges_px4(const SampleTile& tile, const std::vector<ImageEdge>& edges,
                           double enough_px4) {
    const DualLattice dual(tile);
    double sum = 0.0;
    for (const ImageEdge& edge : edges) {
        if (sum > enough_px4)
            break;
        if (edge.right_px != 0.0 || edge.down_px != 0.0)
            sum += varianceOf(edge, dual);
    }
    return sum;
}

std::vector<ImageEdge> withEqualsCounted(const std::vector<ImageEdge>& edges,
                                         const SampleTile& tile) {
    // Both ways along an edge are the same edge.
    std::vector<ImageEdge> sorted = edges;
    for (ImageEdge& edge : sorted)
        if (edge.right_px < 0.0 || (edge.right_px == 0.0 && edge.down_px < 0.0))
            edge = {-edge.right_px, -edge.down_px, edge.count};
    std::ranges::sort(sorted, [](const ImageEdge& a, const ImageEdge& b) {
        return std::pair{a.right_px, a.down_px} < std::pair{b.right_px, b.down_px};
    });

    const double near_px = 0.1 * std::min(tile.cellWidth_px(), tile.cellHeight_px());
    std::vector<ImageEdge> different;
    for (const ImageEdge& edge : sorted) {
        const auto equal = std::ranges::find_if(different, [&](const ImageEdge& other) {
            return std::abs(edge.right_px - other.right_px) < near_px &&
                   std::abs(edge.down_px - other.down_px) < near_px;
        });
        if (equal == different.end()) {
            different.push_back(edge);
            continue;
        }
        // Their mean: which of them comes first may be a matter of rounding.
        const int count = equal->count + edge.count;
        const double share = static_cast<double>(edge.count) / count;
        equal->right_px += share * (edge.right_px - equal->right_px);
        equal->down_px += share * (edge.down_px - equal->down_px);
        equal->count = count;
    }
    return different;
}

std::vector<SampleTile> latticesNear(const SampleTile& tile, int size) {
    std::vector<SampleTile> lattices{tile};
    if (!tile.shearRows)
        return lattices;
    constexpr int otherColumns = 3;
    // Columns in terms of rows, near the tile's own.
    const double shape = static_cast<double>(tile.samplesAcross) / tile.samplesDown;
    const double narrowest = std::min(0.35, 0.55 * shape), widest = 1.4;
    // In terms of the tile's own slope.
    constexpr std::array slopes = {1.0, 16.0 / 12.0, 16.0 / 14.0, 16.0 / 19.0, 16.0 / 24.0, 1.6};
    const double slope = static_cast<double>(tile.samplesDown) /
                         (static_cast<double>(tile.shearRows) * tile.samplesAcross);
    const int fewest = std::min({2, tile.samplesAcross, tile.samplesDown});
    const double perBlock = std::max(static_cast<double>(size) * size /
                                         (static_cast<double>(tile.blocksWide) * tile.blocksHigh),
                                     static_cast<double>(tile.samplesAcross) * tile.samplesDown);
    for (int across = std::max(fewest, tile.samplesAcross - otherColumns);
         across <= tile.samplesAcross + otherColumns; ++across) {
        const int down = static_cast<int>(perBlock / across);
        const double ratio = static_cast<double>(across) / std::max(down, 1);
        if (across * down < tile.samplesAcross * tile.samplesDown || down < fewest ||
            ratio < narrowest || ratio > widest)
            continue;
        for (const double times : slopes)
            for (const int fall : {1, -1, 0}) {
                SampleTile& other = lattices.emplace_back(tile);
                other.samplesAcross = across;
                other.samplesDown = down;
                other.shearRows = static_cast<int>(std::lround(down / (times * slope * across)));
                other.fall = fall;
            }
    }
    return lattices;
}

} // namespace irsg
