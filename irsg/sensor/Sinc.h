#pragma once

#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

/// sin(pi x) / (pi x): the transfer of a slit of width 1.
inline double sinc(double x) {
    const double phase = pi * x;
    return std::abs(phase) < 1e-8 ? 1.0 : std::sin(phase) / phase;
}

} // namespace irsg
