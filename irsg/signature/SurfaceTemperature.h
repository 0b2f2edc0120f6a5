#pragma once

#include "irsg/signature/EntityState.h"
#include "irsg/signature/LookupTable.h"
#include "irsg/signature/TemperatureTerms.h"

namespace irsg {

/// a T_amb, K.
double ambientTerm_K(const TemperatureTerms& terms, const EntityState& state);
/// a T_amb 0.2 r M^2, K.
double aerodynamicTerm_K(const TemperatureTerms& terms, const EntityState& state);
/// a dT, K.
double offsetTerm_K(const TemperatureTerms& terms, const EntityState& state);
/// What a lookup table of the terms adds, K; 0 where it is empty.
double tableTerm_K(const LookupTable& table, double position);

/// The sum of all terms, K. May be <= 0 for a database that is wrong: the caller names the entry.
double surfaceTemperature_K(const TemperatureTerms& terms, const EntityState& state);

} // namespace irsg
