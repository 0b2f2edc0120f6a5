#pragma once

#include "irsg/signature/LookupTable.h"

namespace irsg {

/// The terms of the report's eq. 7, and one more, f_amb(T_amb). Its printed layout is damaged; the
/// reading
///   T = T0 + a T_amb (1 + 0.2 r M^2 + dT / T_amb) + f_time(t) + f_power(P) + f_alt(h) + f_mach(M)
/// fits its seven plus signs and the recovery temperature of air (0.2 = (gamma - 1) / 2). Each term
/// is one function of SurfaceTemperature.h, so that a correction is one line. All in K, and 0
/// unless they are set: a surface of 320 K is `base_K` alone.
struct TemperatureTerms {
    double base_K = 0.0;          ///< T0
    double ambientFactor = 0.0;   ///< a
    double recoveryFactor = 0.0;  ///< r, 0.85 laminar and 0.89 turbulent by custom
    double ambientOffset_K = 0.0; ///< dT
    LookupTable time;             ///< f_time over s; empty tables add nothing
    LookupTable power;            ///< f_power over the power setting
    LookupTable altitude;         ///< f_alt over m
    LookupTable mach;             ///< f_mach over Mach number
    LookupTable ambient = {};     ///< f_amb over the temperature of the air, K; not in the report

    /// Of a surface that is as warm as the air around it.
    static TemperatureTerms ofAmbient() {
        TemperatureTerms terms;
        terms.ambientFactor = 1.0;
        return terms;
    }
    bool operator==(const TemperatureTerms&) const = default;
};

} // namespace irsg
