#pragma once

#include <cstddef>
#include <vector>

#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/SurfaceScene.h"
#include "irsg/scene/view/Sensor.h"
#include "irsg/scene/view/Vec3.h"

namespace irsg {

/// Some rows of a window of a sheet, counted from the top.
struct WindowRows {
    std::size_t window = 0;
    int first = 0, last = 0; ///< `last` is the one after them
};
/// A sheet in the pieces that one thread takes at a time, the same for any number of threads.
std::vector<WindowRows> rowsOf(const SampleSheet& sheet);

/// Place of a sample of a window in its drawing.
inline std::size_t indexOf(const SampleWindow& window, int column, int row) {
    return window.firstSample +
           static_cast<std::size_t>(window.height() - 1 - row) * window.stride() +
           static_cast<std::size_t>(column);
}

/// Unit vector from the eye through a sample, in eye space.
Vec3 eyeDirectionOf(const Sensor& sensor, const SampleWindow& window, int column, int row);

/// Angle between neighbouring samples in the middle of the frame, rad.
double sampleWidthOf(const Sensor& sensor, const SampleWindow& window);

} // namespace irsg
