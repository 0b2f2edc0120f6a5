#pragma once

#include <string>
#include <vector>

#include "irsg/signature/EntityState.h"
#include "irsg/signature/LookupTable.h"

namespace irsg {

/// c_j(t, phi) of eq. 6 for one component: (constant, or time table) x (1, or angle table).
struct ComponentFactor {
    std::string component; ///< name of a component of the spectrum it belongs to
    double constant = 1.0; ///< used where `time` is empty
    LookupTable time;      ///< over s, periodic in loop mode
    LookupTable angle;     ///< over degrees 0 to 180 from the nose axis

    double at(const EntityState& state) const;
    bool operator==(const ComponentFactor&) const = default;
};

using ComponentFactors = std::vector<ComponentFactor>;

} // namespace irsg
