#include "irsg/geometry/view/Sensor.h"

#include <cmath>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {} // namespace

void Sensor::check() const {
    std::vector<Diagnostic> diagnostics;
    const auto checkResolution = [&diagnostics](const std::string& name, int pixels) {
        if (pixels < 1 || pixels > largestResolution_px)
            diagnostics.push_back({"sensor", name, std::to_string(pixels),
                                   "1 to " + std::to_string(largestResolution_px) + " px"});
    };
    checkResolution("width", width_px);
    checkResolution("height", height_px);
    if (!(horizontalFieldOfView_rad > 0.0 && horizontalFieldOfView_rad < pi))
        diagnostics.push_back({"sensor", "horizontal field of view",
                               numberText(degrees(horizontalFieldOfView_rad)) + " deg",
                               "more than 0 and less than 180 deg"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

double Sensor::pixelPitch() const {
    return 2.0 * std::tan(0.5 * horizontalFieldOfView_rad) / static_cast<double>(width_px);
}

double Sensor::cosOffAxis(int x, int y) const {
    return PixelGrid(*this).at(x, y).cosOffAxis;
}

double Sensor::pixelSolidAngle_sr(int x, int y) const {
    return PixelGrid(*this).at(x, y).solidAngle_sr;
}

} // namespace irsg
