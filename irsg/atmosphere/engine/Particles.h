#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/Profile.h"

namespace irsg {

/// How a cloud of particles meets light of one wavelength.
struct ParticleOptics {
    double extinction = 1.0; ///< relative to the extinction at 0.55 um
    double absorption = 0.0; ///< of the same unit, <= extinction
    double asymmetry = 0.0;  ///< of the phase function (Henyey-Greenstein), -1 to 1
};

/// One kind of particles over altitude: an aerosol of one region, a cloud, rain.
struct ParticleLayer {
    std::string name;
    /// Nodes: altitude in m ascending, extinction at 0.55 um in m-1; linear between, 0 outside.
    std::vector<double> altitudes_m;
    std::vector<double> extinction550_per_m;
    /// Optical properties over wavelength in um, ascending; linear in ln(wavelength), held outside.
    std::vector<double> wavelengths_um;
    std::vector<ParticleOptics> optics;

    double extinction550At(double altitude_m) const;
    ParticleOptics opticsAt(double wavelength_um) const;
};

/// The report's aerosol models 0 to 7.
enum class AerosolModel {
    rural = 0,
    urban = 1,
    maritime = 2,
    navyMaritime = 3,
    tropospheric = 4,
    advectiveFog = 5,
    radiativeFog = 6,
    desert = 7
};

struct ParticleSettings {
    std::optional<AerosolModel> aerosol = AerosolModel::rural; ///< none: clear molecular air
    double visibility_m = 0.0;  ///< Koschmieder (2 % contrast, 3.912); 0: the model's own
    int airMass = 3;            ///< ICSTL of the Navy maritime aerosol, 1 ocean to 10 continental
    double windSpeed_m_s = 5.0; ///< now, at windHeight_m
    double windSpeed24h_m_s = 5.0; ///< mean of the last 24 hours
    double windHeight_m = 10.0;
    bool winter = false;           ///< autumn/winter profiles above 2 km, else spring/summer
    int cloudModel = 0;            ///< 0 none, 1 to 5 clouds, 6 to 10 with rain, 18 and 19 cirrus
    double cloudBase_m = -1.0;     ///< negative: the model's own
    double cloudThickness_m = 0.0; ///< 0 or less: the model's own
    double cloudExtinction_per_m = 0.0;        ///< vertical, at 0.55 um; 0 or less: not scaled
    std::optional<ModelAtmosphere> atmosphere; ///< decides the cirrus' own base
};

/// The particles of an atmosphere: boundary layer, free troposphere, stratosphere, above; cloud;
/// rain. Humidity comes from the profile. Throws InputError naming each setting out of range.
std::vector<ParticleLayer> particleLayers(const ParticleSettings& settings, const Profile& profile);

} // namespace irsg
