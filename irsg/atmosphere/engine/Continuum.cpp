#include "irsg/atmosphere/engine/Continuum.h"

#include "irsg/atmosphere/engine/ContinuumParts.h"

namespace irsg {

double continuumAbsorption_per_m(Continuum which, const AirState& air, double wavenumber_cm) {
    switch (which) {
    case Continuum::waterSelf:
        return continuum::waterSelf_per_m(air, wavenumber_cm);
    case Continuum::waterForeign:
        return continuum::waterForeign_per_m(air, wavenumber_cm);
    case Continuum::nitrogen:
        return continuum::nitrogen_per_m(air, wavenumber_cm);
    case Continuum::oxygen:
        return continuum::oxygen_per_m(air, wavenumber_cm);
    case Continuum::ozone:
        return continuum::ozone_per_m(air, wavenumber_cm);
    case Continuum::nitricAcid:
        return continuum::nitricAcid_per_m(air, wavenumber_cm);
    }
    return 0.0;
}

double continuumAbsorption_per_m(const AirState& air, double wavenumber_cm) {
    double sum = 0.0;
    for (std::size_t i = 0; i < continuumCount; ++i)
        sum += continuumAbsorption_per_m(static_cast<Continuum>(i), air, wavenumber_cm);
    return sum;
}

double rayleighScattering_per_m(const AirState& air, double wavenumber_cm) {
    // LOWTRAN 7's formula; relative to air at 273.15 K and 1013.25 hPa.
    const double square = wavenumber_cm * wavenumber_cm;
    const double per_km = square * square / (9.38076e18 - 1.08426e9 * square);
    return 1e-3 * per_km * continuum::amagats(air);
}

} // namespace irsg
