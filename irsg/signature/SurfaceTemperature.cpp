#include "irsg/signature/SurfaceTemperature.h"

#include "irsg/signature/EntryFields.h"

namespace irsg {

double ambientTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return terms.ambientFactor * state.ambient_K;
}

double aerodynamicTerm_K(const TemperatureTerms& terms, const EntityState& state) {
    return ambientTerm_K(terms, state) * 0.2 * terms.recoveryFactor * state.mach * state.mach;
}

double offsetTerm_K(const TemperatureTerms& terms, const EntityState& /*state*/) {
    return terms.ambientFactor * terms.ambientOffset_K;
}

double tableTerm_K(const LookupTable& table, double position) {
    return table.empty() ? 0.0 : table.at(position);
}

double surfaceTemperature_K(const TemperatureTerms& terms, const EntityState& state) {
    double sum_K = terms.base_K + ambientTerm_K(terms, state) + aerodynamicTerm_K(terms, state) +
                   offsetTerm_K(terms, state);
    forEachField<LookupTable>(termFields(), [&](const auto& field, auto member) {
        sum_K += tableTerm_K(terms.*member, field.table.position(state));
    });
    return sum_K;
}

} // namespace irsg
