#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/ContinuumParts.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg::continuum {

namespace {

struct Tables {
    EvenTable nitrogenRotation, nitrogenFundamental, oxygenFundamental, oxygenNearInfrared,
        oxygenVisible;
};

const Tables& tables() {
    static const Tables shipped = [] {
        auto read = [](const char* name, const std::vector<std::string>& columns) {
            return EvenTable::read(atmosphereResource(name), columns);
        };
        const std::vector<std::string> nitrogen = {"k273 [cm-1 amagat-2]", "slope [K]"};
        const std::vector<std::string> oxygen = {"k [cm-1 amagat-2]"};
        return Tables{read("continuum-nitrogen-rotation.csv", nitrogen),
                      read("continuum-nitrogen-fundamental.csv", nitrogen),
                      read("continuum-oxygen.csv", {"S0 [atm-1 cm-1 atm-1]", "A [K-1]", "B [K-2]"}),
                      read("continuum-oxygen-near-infrared.csv", oxygen),
                      read("continuum-oxygen-visible.csv", oxygen)};
    }();
    return shipped;
}

/// The fundamental at 6.4 um: O2 amount (atm-cm) times pressure (atm) times S0 exp(A t + B t^2), t
/// from 220 K. LOWTRAN 7 itself expands the exponential to second order, which it states to be
/// wrong by up to 20 % at 300 K.
double oxygenFundamental_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    const EvenTable& table = tables().oxygenFundamental;
    const EvenTable::Place place = table.place(wavenumber_per_cm);
    if (!place.inside)
        return 0.0;
    const double dT = clampedTemperature_K(air) - 220.0;
    const double A = table.at(1, place), B = table.at(2, place);
    const double strength = table.at(0, place) / 0.20946 * std::exp((A + B * dT) * dT);
    return 100.0 * strength * air.fraction(Gas::O2) * amagats(air) * air.pressure_hPa / 1013.25;
}

/// The Herzberg continuum as in LOWTRAN 7, after Johnston et al. 1984 (J. Geophys. Res. 89, 11661)
/// and Yoshino et al. 1988: taken to 0 at 36000 cm-1 by a straight line between there and 40000
/// cm-1, and stronger in collisions (Shardanand 1977).
double herzberg_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    constexpr double lower_per_cm = 36000.0, full_per_cm = 40000.0, upper_per_cm = 50000.0;
    if (!(wavenumber_per_cm > lower_per_cm && wavenumber_per_cm <= upper_per_cm))
        return 0.0;
    auto cross_cm2 = [](double nu) {
        const double y = nu / 48811.0, logarithm = std::log(y);
        return 6.884e-24 * y * std::exp(-69.738 * logarithm * logarithm);
    };
    static const double atLower_cm2 = cross_cm2(lower_per_cm);
    const double taper =
        std::max(0.0, (full_per_cm - wavenumber_per_cm) / (full_per_cm - lower_per_cm));
    return 100.0 * (cross_cm2(wavenumber_per_cm) - taper * atLower_cm2) * air.fraction(Gas::O2) *
           number_per_cm3(air) * (1.0 + 0.83 * amagats(air));
}

} // namespace

NitrogenSpectral nitrogenAt(double wavenumber_per_cm) {
    for (const EvenTable* table : {&tables().nitrogenRotation, &tables().nitrogenFundamental})
        if (const EvenTable::Place place = table->place(wavenumber_per_cm); place.inside)
            return {table->at(0, place), table->at(1, place)};
    return {};
}

NitrogenAir::NitrogenAir(const AtmosphericState& air) {
    // Of dry air; as collision partners oxygen differs (Lafferty et al. 1996, Appl. Opt. 35, 5911)
    // and water counts as nitrogen.
    constexpr double nitrogenInDryAir = 0.78084;
    const double temperature_K = clampedTemperature_K(air);
    const double nitrogen = nitrogenInDryAir * (1.0 - air.fraction(Gas::H2O));
    const double oxygenEfficiency = 1.294 - 0.4545 * temperature_K / 296.0;
    const double partners =
        nitrogen + oxygenEfficiency * air.fraction(Gas::O2) + air.fraction(Gas::H2O);
    const double density = amagats(air);
    beyond273_per_K = 1.0 / temperature_K - 1.0 / 273.15;
    pairs = 100.0 * density * density * nitrogen * partners;
}

double oxygen_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    const Tables& all = tables();
    const double oxygen = air.fraction(Gas::O2) * amagats(air);
    double perMetre = oxygenFundamental_per_m(air, wavenumber_per_cm);
    perMetre += herzberg_per_m(air, wavenumber_per_cm);
    if (const auto place = all.oxygenNearInfrared.place(wavenumber_per_cm); place.inside)
        perMetre += 100.0 * all.oxygenNearInfrared.at(0, place) * oxygen * amagats(air);
    if (const auto place = all.oxygenVisible.place(wavenumber_per_cm); place.inside)
        perMetre += 100.0 * all.oxygenVisible.at(0, place) * oxygen * oxygen;
    return perMetre;
}

} // namespace irsg::continuum
