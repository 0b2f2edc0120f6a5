#pragma once

#include <string>
#include <vector>

#include "irsg/signature/EntityState.h"
#include "irsg/signature/LookupTable.h"

namespace irsg {

/// Which of what a component factor holds counts (the report's property Selection, F38); the other
/// is kept.
enum class FactorSelection {
    table,   ///< tables where there are any
    constant ///< the constant alone
};

/// c_j(t, phi) of eq. 6 for one component: (constant, or time table) x (1, or angle table), or the
/// constant alone.
struct ComponentFactor {
    std::string component; ///< name of a component of the spectrum it belongs to
    double constant = 1.0; ///< where `time` is empty or the selection is the constant
    LookupTable time;      ///< over s, periodic in loop mode
    LookupTable angle;     ///< over degrees 0 to 180 from the nose axis
    FactorSelection selection = FactorSelection::table;

    double at(const EntityState& state) const;
    bool operator==(const ComponentFactor&) const = default;
};

using ComponentFactors = std::vector<ComponentFactor>;

} // namespace irsg
