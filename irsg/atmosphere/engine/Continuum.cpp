#include "irsg/atmosphere/engine/Continuum.h"

#include "irsg/atmosphere/engine/ContinuumParts.h"

namespace irsg {

double continuumAbsorption_per_m(Continuum which, const AtmosphericState& air,
                                 double wavenumber_per_cm) {
    switch (which) {
    case Continuum::waterSelf:
        return continuum::WaterAir(air).self_per_m(continuum::waterAt(wavenumber_per_cm));
    case Continuum::waterForeign:
        return continuum::WaterAir(air).foreign_per_m(continuum::waterAt(wavenumber_per_cm));
    case Continuum::nitrogen:
        return continuum::NitrogenAir(air).absorption_per_m(
            continuum::nitrogenAt(wavenumber_per_cm));
    case Continuum::oxygen:
        return continuum::oxygen_per_m(air, wavenumber_per_cm);
    case Continuum::ozone:
        return continuum::ozone_per_m(air, wavenumber_per_cm);
    case Continuum::nitricAcid:
        return continuum::nitricAcid_per_m(air, wavenumber_per_cm);
    }
    return 0.0;
}

double continuumAbsorption_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    double sum = 0.0;
    for (std::size_t i = 0; i < continuumCount; ++i)
        sum += continuumAbsorption_per_m(static_cast<Continuum>(i), air, wavenumber_per_cm);
    return sum;
}

namespace {

/// Oxygen, ozone and nitric acid.
double others_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    return continuum::oxygen_per_m(air, wavenumber_per_cm) +
           continuum::ozone_per_m(air, wavenumber_per_cm) +
           continuum::nitricAcid_per_m(air, wavenumber_per_cm);
}

/// Warm, dense air with all gases in it.
AtmosphericState everything() {
    AtmosphericState air;
    air.moleFraction.fill(0.1);
    return air;
}

} // namespace

ContinuumSpectrum::ContinuumSpectrum(std::vector<double> wavenumbers_per_cm)
    : wavenumbers_per_cm_(std::move(wavenumbers_per_cm)) {
    const AtmosphericState absorbing = everything();
    for (const double wavenumber_per_cm : wavenumbers_per_cm_) {
        const continuum::WaterSpectral water = continuum::waterAt(wavenumber_per_cm);
        waterSelf_.push_back(water.self296);
        waterCooling_.push_back(water.lnCooling_per_K);
        waterForeign_.push_back(water.foreign296);
        const continuum::NitrogenSpectral nitrogen = continuum::nitrogenAt(wavenumber_per_cm);
        nitrogen_.push_back(nitrogen.at273);
        nitrogenSlope_.push_back(nitrogen.slope_K);
        if (others_per_m(absorbing, wavenumber_per_cm) > 0.0)
            others_.push_back(waterSelf_.size() - 1);
    }
}

void ContinuumSpectrum::absorption_per_m(const AtmosphericState& air, std::span<double> out) const {
    const continuum::WaterAir water(air);
    const continuum::NitrogenAir nitrogen(air);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = water.both_per_m(
                     {wavenumbers_per_cm_[i], waterSelf_[i], waterCooling_[i], waterForeign_[i]}) +
                 nitrogen.absorption_per_m({nitrogen_[i], nitrogenSlope_[i]});
    for (const std::size_t i : others_)
        out[i] += others_per_m(air, wavenumbers_per_cm_[i]);
}

double rayleighScattering_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    // LOWTRAN 7's formula; relative to air at 273.15 K and 1013.25 hPa.
    const double square = wavenumber_per_cm * wavenumber_per_cm;
    const double per_km = square * square / (9.38076e18 - 1.08426e9 * square);
    return 1e-3 * per_km * continuum::amagats(air);
}

} // namespace irsg
