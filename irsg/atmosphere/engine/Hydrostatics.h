#pragma once

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg {

/// Pressure at the altitude of `there` from the pressure at `here`, hPa: hydrostatic equilibrium of
/// moist air, dp/p = -g M dz / (R T), with the temperature linear between the two, the mean of the
/// two molar masses (water 18.015, dry air 28.964 g/mol) and the gravity of the mid altitude
/// (9.80665 m s-2 at 0). Reads neither the pressure of `there` nor anything above 120 km well.
double hydrostaticPressure_hPa(const AtmosphericState& here, const AtmosphericState& there);

} // namespace irsg
