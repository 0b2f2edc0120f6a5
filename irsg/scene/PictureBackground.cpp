#include "irsg/scene/PictureBackground.h"

#include <algorithm>

namespace irsg {

namespace {

/// What the rows of a picture may be off by (see render.backgroundRows).
constexpr double errorOfRows = 0.005;

} // namespace

FrameBackground pictureBackground(const Frame& frame, const FrameReduction& pixels) {
    const FrameBackground& drawn = frame.backgrounds.byOutput.front();
    const FrameBackground& own = frame.backgrounds.ofSums.front();
    if (frame.scene().entities.size() != 1 || drawn.isUniform() || !own.isUniform())
        return drawn;
    const ObjectRadiometry seen = pixels.objects(drawn, 1.0);
    const double hidden_W_m2 = seen.intensity_W_sr - seen.contrastIntensity_W_sr;
    if (!(seen.solidAngle_sr > 0.0) || !(hidden_W_m2 > 0.0))
        return drawn;
    const double mean_W_m2_sr = hidden_W_m2 / seen.solidAngle_sr;
    const double factor =
        std::clamp(own.centre_W_m2_sr() / mean_W_m2_sr, 1.0 - errorOfRows, 1.0 + errorOfRows);
    return drawn.matched(factor, own.centre_W_m2_sr() - factor * mean_W_m2_sr);
}

} // namespace irsg
