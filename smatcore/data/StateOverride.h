#pragma once

#include <optional>

#include "irsg/signature/EntityState.h"

namespace smat {

/// What one of several models does by itself, whatever the settings or the cases of a sweep say of
/// all of them.
struct StateOverride {
    std::optional<double> power, mach; ///< as all others have them where not set
    double timeOffset_s = 0.0;         ///< that its time is ahead of the scene's

    /// What it does where the others do this.
    irsg::EntityState where(irsg::EntityState others) const {
        others.power = power.value_or(others.power);
        others.mach = mach.value_or(others.mach);
        others.time_s += timeOffset_s;
        return others;
    }
    bool operator==(const StateOverride&) const = default;
};

} // namespace smat
