#include "irsg/atmosphere/engine/Continuum.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg {

namespace {

constexpr double boltzmann_J_K = 1.380649e-23;
constexpr double loschmidt_per_cm3 = 2.6867774e19; ///< at 273.15 K and 1013.25 hPa
constexpr double nitrogenInDryAir = 0.78084;

struct Tables {
    EvenTable water, nitrogenRotation, nitrogenFundamental, oxygen, ozoneVisible, ozoneHuggins,
        ozoneUltraviolet, nitricAcid;
};

const Tables& tables() {
    static const Tables shipped = [] {
        auto read = [](const char* name, const std::vector<std::string>& columns) {
            return EvenTable::read(atmosphereResource(name), columns);
        };
        const std::vector<std::string> nitrogen = {"k220 [cm-1 amagat-2]", "k260 [cm-1 amagat-2]",
                                                   "k300 [cm-1 amagat-2]"};
        return Tables{
            read("continuum-water.csv",
                 {"self296 [1e-20 cm3]", "self260 [1e-20 cm3]", "foreign296 [1e-20 cm3]"}),
            read("continuum-nitrogen-rotation.csv", nitrogen),
            read("continuum-nitrogen-fundamental.csv", nitrogen),
            read("continuum-oxygen.csv", {"S0 [atm-1 cm-1 atm-1]", "A [K-1]", "B [K-2]"}),
            read("continuum-ozone-visible.csv", {"k [atm-1 cm-1]"}),
            read("continuum-ozone-huggins.csv", {"c0 [1e-20 cm2]", "c1 [K-1]", "c2 [K-2]"}),
            read("continuum-ozone-ultraviolet.csv", {"sigma [1e-20 cm2]"}),
            read("continuum-nitric-acid.csv", {"k [atm-1 cm-1]"})};
    }();
    return shipped;
}

double heldTemperature_K(const AirState& air) {
    return std::clamp(air.temperature_K, 150.0, 350.0);
}

/// v tanh(c2 v / 2 T), cm-1.
double radiationTerm_cm(double wavenumber_cm, double temperature_K) {
    return wavenumber_cm * std::tanh(1.438776877 * wavenumber_cm / (2.0 * temperature_K));
}

double numberPer_cm3(const AirState& air) {
    return air.airDensity_per_m3() * 1e-6;
}

/// Density in amagats: relative to that of a perfect gas at 273.15 K and 1013.25 hPa.
double amagats(const AirState& air) {
    return numberPer_cm3(air) / loschmidt_per_cm3;
}

double water_per_m(const AirState& air, double wavenumber_cm, bool self) {
    const EvenTable& table = tables().water;
    const EvenTable::Place place = table.place(wavenumber_cm);
    if (!place.inside)
        return 0.0;
    const double temperature_K = heldTemperature_K(air);
    const double reference_per_cm3 = 101325.0 / (boltzmann_J_K * 296.0) * 1e-6;
    const double water_per_cm3 = air.fraction(Gas::H2O) * numberPer_cm3(air);
    double coefficient = 0.0, partner_per_cm3 = 0.0;
    if (self) {
        // The logarithm of the self continuum is linear in temperature.
        const double warm = table.at(0, place), cool = table.at(1, place);
        if (warm > 0.0)
            coefficient = warm * std::pow(cool / warm, (296.0 - temperature_K) / 36.0);
        partner_per_cm3 = water_per_cm3;
    } else {
        coefficient = table.at(2, place);
        partner_per_cm3 = numberPer_cm3(air) - water_per_cm3;
    }
    return 100.0 * water_per_cm3 * coefficient * 1e-20 *
           radiationTerm_cm(wavenumber_cm, temperature_K) * partner_per_cm3 / reference_per_cm3;
}

double nitrogen_per_m(const AirState& air, double wavenumber_cm) {
    double perAmagat2_cm = 0.0;
    const double temperature_K = std::clamp(air.temperature_K, 180.0, 340.0);
    for (const EvenTable* table : {&tables().nitrogenRotation, &tables().nitrogenFundamental}) {
        const EvenTable::Place place = table->place(wavenumber_cm);
        if (!place.inside)
            continue;
        // A parabola through the three temperatures of the table.
        const double t = (temperature_K - 260.0) / 40.0;
        const double cold = table->at(0, place), middle = table->at(1, place),
                     warm = table->at(2, place);
        perAmagat2_cm +=
            middle + 0.5 * t * (warm - cold) + 0.5 * t * t * (warm - 2.0 * middle + cold);
    }
    const double dry = 1.0 - air.fraction(Gas::H2O);
    const double nitrogen = nitrogenInDryAir * dry;
    // Oxygen as the partner is a little stronger (Lafferty et al. 1996).
    const double oxygenEfficiency = 1.294 - 0.4545 * temperature_K / 296.0;
    const double partners =
        nitrogen + oxygenEfficiency * air.fraction(Gas::O2) + air.fraction(Gas::H2O);
    const double density = amagats(air);
    return 100.0 * std::max(perAmagat2_cm, 0.0) * density * density * nitrogen * partners;
}

double oxygen_per_m(const AirState& air, double wavenumber_cm) {
    const EvenTable& table = tables().oxygen;
    const EvenTable::Place place = table.place(wavenumber_cm);
    if (!place.inside)
        return 0.0;
    const double dT = heldTemperature_K(air) - 220.0;
    const double A = table.at(1, place), B = table.at(2, place);
    const double amount_atm = air.fraction(Gas::O2) * amagats(air); // atm-cm in 1 cm of path
    const double strength =
        table.at(0, place) / 0.20946 * (1.0 + A * dT + (0.5 * A * A + B) * dT * dT);
    return 100.0 * std::max(strength, 0.0) * amount_atm * air.pressure_hPa / 1013.25;
}

double ozone_per_m(const AirState& air, double wavenumber_cm) {
    const Tables& all = tables();
    const double ozone_per_cm3 = air.fraction(Gas::O3) * numberPer_cm3(air);
    const EvenTable::Place huggins = all.ozoneHuggins.place(wavenumber_cm);
    double cross_cm2 = 0.0;
    if (huggins.inside) {
        const double dT = heldTemperature_K(air) - 273.15;
        cross_cm2 = 1e-20 * all.ozoneHuggins.at(0, huggins) *
                    (1.0 + all.ozoneHuggins.at(1, huggins) * dT +
                     all.ozoneHuggins.at(2, huggins) * dT * dT);
    } else if (const auto far = all.ozoneUltraviolet.place(wavenumber_cm); far.inside) {
        cross_cm2 = 1e-20 * all.ozoneUltraviolet.at(0, far);
    } else if (const auto visible = all.ozoneVisible.place(wavenumber_cm); visible.inside) {
        cross_cm2 = all.ozoneVisible.at(0, visible) / loschmidt_per_cm3;
    }
    return 100.0 * std::max(cross_cm2, 0.0) * ozone_per_cm3;
}

double nitricAcid_per_m(const AirState& air, double wavenumber_cm) {
    const EvenTable& table = tables().nitricAcid;
    return 100.0 * table.at(0, table.place(wavenumber_cm)) * air.fraction(Gas::HNO3) * amagats(air);
}

} // namespace

double continuumAbsorption_per_m(Continuum which, const AirState& air, double wavenumber_cm) {
    switch (which) {
    case Continuum::waterSelf:
        return water_per_m(air, wavenumber_cm, true);
    case Continuum::waterForeign:
        return water_per_m(air, wavenumber_cm, false);
    case Continuum::nitrogen:
        return nitrogen_per_m(air, wavenumber_cm);
    case Continuum::oxygen:
        return oxygen_per_m(air, wavenumber_cm);
    case Continuum::ozone:
        return ozone_per_m(air, wavenumber_cm);
    case Continuum::nitricAcid:
        return nitricAcid_per_m(air, wavenumber_cm);
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
    return 1e-3 * per_km * amagats(air);
}

} // namespace irsg
