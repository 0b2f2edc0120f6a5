#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "irsg/atmosphere/Environment.h"

namespace irsg {

/// Which atmospheres an environment has, in their order, without keeping them: computed air holds
/// tens of megabytes. What was kept for air that is gone is of no more use to anybody.
class AtmosphereIdentity {
  public:
    explicit AtmosphereIdentity(const Environment& environment)
        : atmospheres_(environment.atmospheres().begin(), environment.atmospheres().end()) {}

    bool isOf(const Environment& environment) const {
        return *this == AtmosphereIdentity(environment);
    }
    /// That one of them is no longer there: no environment will ever have these again.
    bool isGone() const {
        return std::ranges::any_of(atmospheres_, [](const auto& air) { return air.expired(); });
    }
    bool operator==(const AtmosphereIdentity& other) const {
        return std::ranges::equal(
            atmospheres_, other.atmospheres_, [](const auto& one, const auto& another) {
                return !one.owner_before(another) && !another.owner_before(one);
            });
    }

  private:
    std::vector<std::weak_ptr<const Atmosphere>> atmospheres_;
};

} // namespace irsg
