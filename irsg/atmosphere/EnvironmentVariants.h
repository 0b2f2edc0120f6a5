#pragma once

#include "irsg/atmosphere/Environment.h"

namespace irsg {

/// The same environment in air that is computed without tables (IrradianceMode 2), so that what it
/// answers does not depend on what it was asked before: cases of a sweep are the same in any order
/// and in any parts. The air of equal atmospheres is one.
inline Environment onTheFly(const Environment& environment) {
    return environment.with([](const Atmosphere& one) { return one.onTheFly(); });
}

/// The same environment with bins of 1, 5 or 15 cm-1 in all air that has bins.
inline Environment withBins(const Environment& environment, int resolution_per_cm) {
    return environment.with([&](const Atmosphere& one) { return one.withBins(resolution_per_cm); });
}

} // namespace irsg
