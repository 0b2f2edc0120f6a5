#include "irsg/gas/NarrowBand.h"

#include <algorithm>
#include <cmath>

namespace irsg {

double collisionDepth(StrengthLaw law, double depth, double collision) {
    if (!(collision > 0.0) || !(depth > 0.0))
        return 0.0;
    const double ratio = depth / collision;
    if (law == StrengthLaw::goody)
        return depth / std::sqrt(1.0 + 0.25 * ratio);
    // 2a (sqrt(1 + X/a) - 1) without the difference of near numbers.
    return 2.0 * depth / (std::sqrt(1.0 + ratio) + 1.0);
}

double dopplerDepth(StrengthLaw law, double depth, double doppler) {
    if (!(doppler > 0.0) || !(depth > 0.0))
        return 0.0;
    const double ratio = depth / doppler;
    if (law == StrengthLaw::goody) {
        const double x = 0.58824 * ratio;
        return std::min(depth, 1.7 * doppler * std::sqrt(std::log1p(x * x)));
    }
    const double logarithm = std::log1p(std::pow(1.07 * ratio, 2.0 / 3.0));
    return std::min(depth, 0.937 * doppler * logarithm * std::sqrt(logarithm));
}

double NarrowBandSum::opticalDepth(StrengthLaw law) const {
    if (!(depth_ > 0.0))
        return 0.0;
    constexpr double linear = 1e-12; // shares of saturated lines below this change nothing
    const double mean = 1.0 / depth_;
    const double collision = collisionDepth(law, depth_, collision_ * mean) * mean;
    const double doppler = dopplerDepth(law, depth_, doppler_ * mean) * mean;
    const double byCollision = std::max(1.0 - collision * collision, linear);
    const double byDoppler = std::max(1.0 - doppler * doppler, linear);
    const double both =
        std::max(1.0 / (byCollision * byCollision) + 1.0 / (byDoppler * byDoppler) - 1.0, 1.0);
    return depth_ * std::sqrt(1.0 - 1.0 / std::sqrt(both));
}

} // namespace irsg
