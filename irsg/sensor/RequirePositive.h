#pragma once

#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

/// Throws InputError, with what a value is of and what was expected, unless it is finite and
/// above 0.
inline void requirePositive(double value, const char* what, const char* expected) {
    if (!(value > 0.0 && std::isfinite(value)))
        throw InputError({"", what, numberText(value), expected});
}

} // namespace irsg
