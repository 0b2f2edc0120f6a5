#include "irsg/render/sampling/SampleTile.h"

#include <cmath>
#include <utility>

namespace irsg {

SampleTile SampleTile::ofFrame(int side_px, std::vector<int> entities) {
    SampleTile tile;
    tile.blocksWide = tile.blocksHigh = side_px;
    tile.entities = std::move(entities);
    return tile;
}

double SampleTile::blockSide_px() const {
    return std::ldexp(1.0, -level);
}

ImageRectangle SampleTile::rectangle() const {
    const double side_px = blockSide_px();
    return {static_cast<double>(blockX) * side_px, static_cast<double>(blockY) * side_px,
            static_cast<double>(blockX + blocksWide) * side_px,
            static_cast<double>(blockY + blocksHigh) * side_px};
}

ImageRectangle SampleTile::renderedRectangle() const {
    ImageRectangle drawn = rectangle();
    drawn.right = drawn.left + width() * blockSide_px() / samplesAcross;
    return drawn;
}

PixelRegion SampleTile::pixels() const {
    const auto first = [&](std::int64_t block) { return static_cast<int>(block >> level); };
    const int x = first(blockX), y = first(blockY);
    return {x, y, first(blockX + blocksWide - 1) - x + 1, first(blockY + blocksHigh - 1) - y + 1};
}

std::pair<double, double> SampleTile::placeOf(int column, int row) const {
    // Rows are moved after they are tilted.
    const double down = row + drop(column);
    const double right = column - (shearRows ? down / shearRows : 0.0);
    const ImageRectangle all = rectangle();
    return {all.left + (right + 0.5) * cellWidth_px(), all.top + (down + 0.5) * cellHeight_px()};
}

double SampleTile::share() const {
    return std::ldexp(1.0 / (static_cast<double>(samplesAcross) * samplesDown), -2 * level);
}

double SampleTile::density() const {
    return std::ldexp(static_cast<double>(std::min(samplesAcross, samplesDown)), level);
}

std::vector<SampleTile> SampleTile::pieces(int side) const {
    const int across = std::max(1, side / samplesAcross), down = std::max(1, side / samplesDown);
    std::vector<SampleTile> result;
    for (int y = 0; y < blocksHigh; y += down)
        for (int x = 0; x < blocksWide; x += across) {
            SampleTile& piece = result.emplace_back(*this);
            piece.blockX += x;
            piece.blockY += y;
            piece.blocksWide = std::min(across, blocksWide - x);
            piece.blocksHigh = std::min(down, blocksHigh - y);
        }
    return result;
}

ImageRectangle SampleTile::cellsAround(const ImageRectangle& part) const {
    const ImageRectangle all = rectangle();
    constexpr double rounding = 1e-6; // of a place that is the border of a cell already
    const auto before = [](double place_px, double origin_px, double side_px) {
        return origin_px + side_px * std::floor((place_px - origin_px) / side_px + rounding);
    };
    const auto after = [](double place_px, double origin_px, double side_px) {
        return origin_px + side_px * std::ceil((place_px - origin_px) / side_px - rounding);
    };
    const double wide_px = cellWidth_px(), high_px = cellHeight_px();
    return ImageRectangle{before(part.left, all.left, wide_px), before(part.top, all.top, high_px),
                          after(part.right, all.left, wide_px),
                          after(part.bottom, all.top, high_px)}
        .intersectedWith(region());
}

std::vector<double> SampleTile::weightsOf(int row) const {
    const ImageRectangle all = rectangle();
    const double wide_px = cellWidth_px(), high_px = cellHeight_px();
    std::vector<double> weights(static_cast<std::size_t>(blocksWide * samplesAcross), 1.0);
    const double top = all.top + row * high_px;
    if (only) {
        const auto inside = [](double low, double high, double from, double to) {
            return std::max(0.0, std::min(high, to) - std::max(low, from)) / (high - low);
        };
        const double rows = inside(top, top + high_px, only->top, only->bottom);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double left = all.left + static_cast<double>(i) * wide_px;
            weights[i] = rows * inside(left, left + wide_px, only->left, only->right);
        }
    }
    const ImageRectangle drawn = region();
    for (ImageRectangle part : leftOut) {
        // A cell across the border of what is drawn is the part's, too.
        if (part.left <= drawn.left)
            part.left = all.left;
        if (part.right >= drawn.right)
            part.right = all.right;
        if (part.top <= drawn.top)
            part.top = all.top;
        if (part.bottom >= drawn.bottom)
            part.bottom = all.bottom;
        if (top + 0.5 * high_px < part.top || top + 0.5 * high_px >= part.bottom)
            continue;
        const auto cell = [&](double x) {
            return static_cast<std::ptrdiff_t>(std::clamp(std::round((x - all.left) / wide_px), 0.0,
                                                          static_cast<double>(weights.size())));
        };
        std::fill(weights.begin() + cell(part.left), weights.begin() + cell(part.right), 0.0);
    }
    return weights;
}

} // namespace irsg
