#pragma once

#include <string>
#include <vector>

#include "irsg/atmosphere/engine/ParticleTable.h"
#include "irsg/atmosphere/engine/Particles.h"

// The pieces from which particleLayers() puts the particles of an atmosphere together.
namespace irsg::particles {

/// Optical properties over wavelength, relative to the extinction at 0.55 um.
struct Optics {
    std::vector<double> wavelengths_um;
    std::vector<ParticleOptics> values;
};

/// The columns PREFIX_ext, PREFIX_abs and PREFIX_asym, each followed by `suffix`, as they are.
Optics opticsOf(const ParticleTable& table, const std::string& prefix,
                const std::string& suffix = "");
/// Their names, for ParticleTable::read.
std::vector<std::string> opticsColumns(const std::vector<std::string>& prefixes,
                                       const std::vector<std::string>& suffixes);
/// Fogs, high aerosols, clouds and cirrus: what does not depend on humidity or wind.
Optics dryOptics(const std::string& kind);
/// Rural, urban, maritime or tropospheric aerosol (Shettle and Fenn 1979). The logarithms of
/// extinction and absorption and the asymmetry are linear in ln(100 - RH) between 0, 70, 80 and 99
/// % (as in LOWTRAN 7); clamped beyond 99 %.
Optics humidOptics(const std::string& model, double relativeHumidity);

/// Optics between two neighbours, `part` 0 to 1 of the way: logarithms of extinction and
/// absorption (the values themselves where one is 0) and the asymmetry linear.
ParticleOptics between(const ParticleOptics& a, const ParticleOptics& b, double part);
/// Divided by the extinction at 0.55 um.
Optics normalised(Optics optics);

/// Wind at 10 m from wind at another height, u10 = u ln(10/z0) / ln(z/z0): the logarithmic law of
/// neutral air over ground of roughness length z0.
double windAt10m(double wind_m_s, double height_m, double roughness_m);
/// Roughness of the open sea and of featureless land (Wieringa 1992, J. Wind Eng. Ind. Aerodyn.
/// 41, 357, classes 1 and 2).
inline constexpr double seaRoughness_m = 2e-4;
inline constexpr double desertRoughness_m = 5e-3;

/// Extinction at 0.55 um that a visibility means, m-1: 3.912 / V less 0.01159 km-1 of Rayleigh
/// scattering, as LOWTRAN 7 reckons; and the reverse.
double koschmiederExtinction_per_m(double visibility_m);
double koschmiederVisibility_m(double extinction550_per_m);

/// An aerosol of the boundary layer that finds its own strength: by wind, air mass, humidity.
struct WindAerosol {
    Optics optics;
    double extinction550_per_m = 0.0;
};
/// Gathman 1983, with the limits of LOWTRAN 7; winds at 10 m.
WindAerosol navyMaritime(int airMass, double wind_m_s, double wind24h_m_s, double relativeHumidity);
/// Longtin et al. 1988; wind at 10 m.
WindAerosol desert(double wind_m_s);

/// All aerosols from the ground to 100 km.
std::vector<ParticleLayer> aerosols(const ParticleSettings& settings,
                                    const HumidityProfile& relativeHumidityAt);
/// The cloud and, where it rains, the rain; nothing for cloud model 0.
std::vector<ParticleLayer> clouds(const ParticleSettings& settings);

/// Where a cloud lies by the settings, m above ground.
struct CloudPlace {
    double ownBase_m = 0.0;
    double ownThickness_m = 0.0;
    double base_m = 0.0;
    double thickness_m = 0.0;
};
/// For the known cloud models other than 0.
CloudPlace cloudPlace(const ParticleSettings& settings);

/// Throws InputError with every setting out of range and every impossible combination.
void check(const ParticleSettings& settings);

} // namespace irsg::particles
