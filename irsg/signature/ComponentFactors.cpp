#include "irsg/signature/ComponentFactors.h"

#include "irsg/radiometry/Units.h"

namespace irsg {

double ComponentFactor::at(const EntityState& state) const {
    if (selection == FactorSelection::constant)
        return constant;
    const double overTime = time.empty() ? constant : time.at(state.time_s);
    const double overAngle = angle.empty() ? 1.0 : angle.at(degrees(state.aspectAngle_rad));
    return overTime * overAngle;
}

} // namespace irsg
