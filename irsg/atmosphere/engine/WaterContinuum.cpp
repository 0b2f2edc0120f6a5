#include <cmath>

#include "irsg/atmosphere/engine/ContinuumParts.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg::continuum {

namespace {

enum Column : std::size_t { self296, self260, foreign296 };
constexpr double reference_per_cm3 = 101325.0 / (1.380649e-23 * 296.0) * 1e-6;

const EvenTable& table() {
    static const EvenTable shipped =
        EvenTable::read(atmosphereResource("continuum-water.csv"),
                        {"self296 [1e-20 cm3]", "self260 [1e-20 cm3]", "foreign296 [1e-20 cm3]"});
    return shipped;
}

/// m-1 of a coefficient in 1e-20 cm3 molecule-1 between water and partners of a density.
double absorption_per_m(double coefficient, double water_per_cm3, double partner_per_cm3,
                        double wavenumber_cm, double temperature_K) {
    return 1e-18 * coefficient * radiationTerm_cm(wavenumber_cm, temperature_K) * water_per_cm3 *
           partner_per_cm3 / reference_per_cm3;
}

} // namespace

double waterSelf_per_m(const AirState& air, double wavenumber_cm) {
    const EvenTable::Place place = table().place(wavenumber_cm);
    const double water_per_cm3 = air.fraction(Gas::H2O) * numberPer_cm3(air);
    if (!place.inside || water_per_cm3 <= 0.0)
        return 0.0;
    const double warm = table().at(self296, place), cool = table().at(self260, place);
    if (warm <= 0.0 || cool <= 0.0)
        return 0.0;
    // The logarithm of the self continuum is linear in temperature (LOWTRAN 7).
    const double temperature_K = heldTemperature_K(air);
    const double coefficient = warm * std::pow(cool / warm, (296.0 - temperature_K) / 36.0);
    return absorption_per_m(coefficient, water_per_cm3, water_per_cm3, wavenumber_cm,
                            temperature_K);
}

double waterForeign_per_m(const AirState& air, double wavenumber_cm) {
    const EvenTable::Place place = table().place(wavenumber_cm);
    const double all_per_cm3 = numberPer_cm3(air);
    const double water_per_cm3 = air.fraction(Gas::H2O) * all_per_cm3;
    if (!place.inside || water_per_cm3 <= 0.0)
        return 0.0;
    return absorption_per_m(table().at(foreign296, place), water_per_cm3,
                            all_per_cm3 - water_per_cm3, wavenumber_cm, heldTemperature_K(air));
}

} // namespace irsg::continuum
