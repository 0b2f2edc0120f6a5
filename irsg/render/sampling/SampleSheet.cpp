#include "irsg/render/sampling/SampleSheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace irsg {

namespace {

double samplesOf(const SampleTile& tile) {
    return static_cast<double>(tile.width()) * tile.height();
}

/// Beyond, nothing is gained by drawing more in one go, but memory taken.
constexpr double mostSamples = 400'000.0;

/// Places tiles on shelves, the highest first; nothing where that takes more than a side.
SampleSheet sheetOf(std::vector<SampleTile> tiles, int largestSide) {
    if (tiles.size() == 1)
        return SampleSheet::of(tiles.front());
    double all = 0.0;
    SampleSheet sheet;
    for (const SampleTile& tile : tiles) {
        all += samplesOf(tile);
        sheet.width = std::max(sheet.width, tile.width());
    }
    sheet.width = std::clamp(static_cast<int>(std::sqrt(all)), sheet.width, largestSide);

    std::vector<std::size_t> order(tiles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t i) { return tiles[i].height(); });
    int x = 0, shelf = 0;
    for (const std::size_t i : order) {
        if (x + tiles[i].width() > sheet.width) {
            x = 0;
            shelf = sheet.height;
        }
        tiles[i].placeIn(sheet.width, x, shelf);
        x += tiles[i].width();
        sheet.height = std::max(sheet.height, shelf + tiles[i].height());
    }
    sheet.tiles = std::move(tiles);
    return sheet;
}

} // namespace

std::vector<SampleSheet> sheetsOf(std::vector<SampleTile> tiles, int largestSide) {
    std::vector<SampleSheet> sheets;
    std::vector<SampleTile> together;
    double samples = 0.0;
    const auto close = [&] {
        if (together.empty())
            return;
        SampleSheet sheet = sheetOf(together, largestSide);
        if (sheet.height <= largestSide)
            sheets.push_back(std::move(sheet));
        else
            for (SampleTile& tile : together)
                sheets.push_back(sheetOf({std::move(tile)}, largestSide));
        together.clear();
        samples = 0.0;
    };
    for (SampleTile& tile : tiles) {
        const double own = samplesOf(tile);
        if (samples + own > mostSamples)
            close();
        samples += own;
        together.push_back(std::move(tile));
    }
    close();
    return sheets;
}

} // namespace irsg
