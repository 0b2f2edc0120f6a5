#include "irsg/render/rays/WindowSamples.h"

#include <algorithm>

namespace irsg {

std::vector<WindowRows> rowsOf(const SampleSheet& sheet) {
    constexpr int atOnce = 8;
    std::vector<WindowRows> pieces;
    for (std::size_t w = 0; w < sheet.windows.size(); ++w)
        for (int row = 0; row < sheet.windows[w].height(); row += atOnce)
            pieces.push_back({w, row, std::min(row + atOnce, sheet.windows[w].height())});
    return pieces;
}

EyeDirections::EyeDirections(const Sensor& sensor, const SampleWindow& window)
    : fall_(window.fall),
      width_(window.width()),
      shearRows_(window.shearRows),
      left_(window.rectangle().left),
      top_(window.rectangle().top),
      cellWidth_(window.cellWidth_px()),
      cellHeight_(window.cellHeight_px()),
      middleX_(0.5 * sensor.width_px),
      middleY_(0.5 * sensor.height_px),
      pitch_(sensor.pixelPitch()) {}

double sampleWidthOf(const Sensor& sensor, const SampleWindow& window) {
    return sensor.pixelPitch() * std::max(window.cellWidth_px(), window.cellHeight_px());
}

} // namespace irsg
