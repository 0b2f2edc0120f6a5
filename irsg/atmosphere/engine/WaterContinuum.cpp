#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/ContinuumParts.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg::continuum {

namespace {

enum Column : std::size_t { self296, self260, foreign296 };
constexpr double reference_per_cm3 = 101325.0 / (1.380649e-23 * 296.0) * 1e-6;

const EvenTable& waterTable() {
    static const EvenTable shipped =
        EvenTable::read(atmosphereResource("continuum-water.csv"),
                        {"self296 [1e-20 cm3]", "self260 [1e-20 cm3]", "foreign296 [1e-20 cm3]"});
    return shipped;
}

} // namespace

WaterSpectral waterAt(double wavenumber_per_cm) {
    const EvenTable::Place place = waterTable().place(wavenumber_per_cm);
    WaterSpectral water;
    water.wavenumber_per_cm = wavenumber_per_cm;
    water.foreign296 = waterTable().at(foreign296, place);
    const double warm = waterTable().at(self296, place), cool = waterTable().at(self260, place);
    if (warm > 0.0 && cool > 0.0) {
        water.self296 = warm;
        water.lnCooling_per_K = std::log(cool / warm) / 36.0;
    }
    return water;
}

WaterAir::WaterAir(const AtmosphericState& air) {
    const double all_per_cm3 = number_per_cm3(air);
    const double water_per_cm3 = std::max(air.fraction(Gas::H2O) * all_per_cm3, 0.0);
    const double perCoefficient = 1e-18 * water_per_cm3 / reference_per_cm3;
    cooling_K = 296.0 - clampedTemperature_K(air);
    perTemperature_per_K = 1.0 / clampedTemperature_K(air);
    self = perCoefficient * water_per_cm3;
    foreign = perCoefficient * (all_per_cm3 - water_per_cm3);
}

} // namespace irsg::continuum
