#include "irsg/render/background/GroundDistance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace irsg {

GroundDistance::GroundDistance(double altitude_m, double horizon_rad)
    : altitude_m_(altitude_m), horizon_rad_(std::min(horizon_rad, 0.0)) {
    // cos(dip) = R / (R + h).
    const double half = std::sin(0.5 * horizon_rad_);
    if (half < 0.0 && altitude_m > 0.0) {
        perCentre_1_m_ = 2.0 * half * half / altitude_m;
        toHorizon_m_ = std::sin(-horizon_rad_) / perCentre_1_m_;
    }
}

double GroundDistance::belowHorizon_rad(double distance_m) const {
    const bool isSphere = perCentre_1_m_ > 0.0;
    if (isSphere && distance_m >= toHorizon_m_)
        return 0.0;
    // Law of cosines between the sensor, the centre of the sphere and the ground.
    const double sine =
        isSphere ? 0.5 * perCentre_1_m_ * (toHorizon_m_ * toHorizon_m_ / distance_m + distance_m)
                 : altitude_m_ / distance_m;
    const double depression_rad = sine < 1.0 ? std::asin(sine) : 0.5 * std::numbers::pi;
    return std::max(depression_rad + horizon_rad_, 0.0);
}

} // namespace irsg
