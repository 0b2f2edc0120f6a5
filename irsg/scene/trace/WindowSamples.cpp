#include "irsg/scene/trace/WindowSamples.h"

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

Vec3 eyeDirectionOf(const Sensor& sensor, const SampleWindow& window, int column, int row) {
    const auto [right_px, below_px] = window.placeOf(column, row);
    const double pitch = sensor.pixelPitch();
    return normalized({(right_px - 0.5 * sensor.width_px) * pitch,
                       (0.5 * sensor.height_px - below_px) * pitch, -1.0});
}

double sampleWidthOf(const Sensor& sensor, const SampleWindow& window) {
    return sensor.pixelPitch() * std::max(window.cellWidth_px(), window.cellHeight_px());
}

} // namespace irsg
