#include "irsg/render/rays/TileSamples.h"

#include <algorithm>

namespace irsg {

std::vector<TileRows> rowsOf(const SampleSheet& sheet) {
    constexpr int atOnce = 8;
    std::vector<TileRows> pieces;
    for (std::size_t w = 0; w < sheet.tiles.size(); ++w)
        for (int row = 0; row < sheet.tiles[w].height(); row += atOnce)
            pieces.push_back({w, row, std::min(row + atOnce, sheet.tiles[w].height())});
    return pieces;
}

EyeDirections::EyeDirections(const Sensor& sensor, const SampleTile& tile)
    : fall_(tile.fall),
      width_(tile.width()),
      shearRows_(tile.shearRows),
      left_(tile.rectangle().left),
      top_(tile.rectangle().top),
      cellWidth_(tile.cellWidth_px()),
      cellHeight_(tile.cellHeight_px()),
      middleX_(0.5 * sensor.width_px),
      middleY_(0.5 * sensor.height_px),
      pitch_(sensor.pixelPitch()) {}

double sampleWidthOf(const Sensor& sensor, const SampleTile& tile) {
    return sensor.pixelPitch() * std::max(tile.cellWidth_px(), tile.cellHeight_px());
}

} // namespace irsg
