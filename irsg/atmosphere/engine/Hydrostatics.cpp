#include "irsg/atmosphere/engine/Hydrostatics.h"

#include <cmath>

#include "irsg/atmosphere/path/Earth.h"

namespace irsg {

double hydrostaticPressure_hPa(const AtmosphericState& here, const AtmosphericState& there) {
    constexpr double gasConstant = 8.314462618;
    const double water = 0.5 * (here.fraction(Gas::H2O) + there.fraction(Gas::H2O));
    const double molarMass_kg = 28.964e-3 + water * (18.015e-3 - 28.964e-3);
    const double middle = earthRadius_m + 0.5 * (here.altitude_m + there.altitude_m);
    const double gravity = 9.80665 * (earthRadius_m / middle) * (earthRadius_m / middle);

    // The mean of 1/T over a linear T: log(T2/T1) / (T2 - T1).
    const double difference_K = there.temperature_K - here.temperature_K;
    const double inverse = std::abs(difference_K) < 1e-6 * here.temperature_K
                               ? 2.0 / (here.temperature_K + there.temperature_K)
                               : std::log1p(difference_K / here.temperature_K) / difference_K;
    return here.pressure_hPa * std::exp(-gravity * molarMass_kg / gasConstant * inverse *
                                        (there.altitude_m - here.altitude_m));
}

} // namespace irsg
