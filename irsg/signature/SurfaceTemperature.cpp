#include "irsg/signature/SurfaceTemperature.h"

namespace irsg {

namespace {

double valueOrNothing(const LookupTable& table, double x) {
    return table.empty() ? 0.0 : table.at(x);
}

} // namespace

double ambientTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return terms.ambientFactor * state.ambient_K;
}

double aerodynamicTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return ambientTerm_K(terms, state) * 0.2 * terms.recoveryFactor * state.mach * state.mach;
}

double offsetTerm_K(const TemperatureTerms& terms, const EntityState& /*state*/) {
    return terms.ambientFactor * terms.ambientOffset_K;
}

double timeTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return valueOrNothing(terms.time, state.time_s);
}

double powerTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return valueOrNothing(terms.power, state.power);
}

double altitudeTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return valueOrNothing(terms.altitude, state.altitude_m);
}

double machTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return valueOrNothing(terms.mach, state.mach);
}

double surfaceTemperature_K(const TemperatureTerms& terms, const EntityState& state) {
    return terms.base_K + ambientTerm_K(terms, state) + aerodynamicTerm_K(terms, state) +
           offsetTerm_K(terms, state) + timeTerm_K(terms, state) + powerTerm_K(terms, state) +
           altitudeTerm_K(terms, state) + machTerm_K(terms, state);
}

} // namespace irsg
