#pragma once

#include <utility>

#include "irsg/atmosphere/Environment.h"

namespace irsg {

/// The same environment in air that is computed without tables (IrradianceMode 2), so that what it
/// answers does not depend on what it was asked before: cases of a sweep are the same in any order
/// and in any parts. The air of equal atmospheres is one.
inline Environment onTheFly(Environment environment) {
    Environment made;
    for (const auto& atmosphere : environment.atmospheres()) {
        const auto other = atmosphere->onTheFly();
        made.add(other ? other : atmosphere);
    }
    made.sun = environment.sun;
    made.defaultBackground = std::move(environment.defaultBackground);
    made.defaultAmbient_K = environment.defaultAmbient_K;
    return made;
}

} // namespace irsg
