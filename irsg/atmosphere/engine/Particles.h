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
    /// Optical properties over wavelength in um, ascending. Between nodes the extinction is a power
    /// law of the wavelength, the absorbed part of it and the asymmetry are linear in
    /// ln(wavelength), as MODTRAN's columns show. Clamped outside.
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
    /// Koschmieder (2 % contrast, 3.912), 10 m to 300 km; 0: the model's own.
    double visibility_m = 0.0;
    int airMass = 3;            ///< ICSTL of the Navy maritime aerosol, 1 ocean to 10 continental
    double windSpeed_m_s = 5.0; ///< now, at windHeight_m, 0.1 to 30
    double windSpeed24h_m_s = 5.0; ///< mean of the last 24 hours
    double windHeight_m = 10.0;    ///< of both winds above ground, 2 to 40
    /// Of the ground above sea level, 0 to 5000: aerosols below 6 km are pressed together between
    /// it and there, those above stay where they are, as with MODTRAN's GNDALT.
    double ground_m = 0.0;
    bool winter = false;           ///< autumn/winter profiles above 2 km, else spring/summer
    int cloudModel = 0;            ///< 0 none, 1 to 5 clouds, 6 to 10 with rain, 18 and 19 cirrus
    double cloudBase_m = -1.0;     ///< negative: the model's own
    double cloudThickness_m = 0.0; ///< 0 or less: the model's own
    /// At 0.55 um, mean over the thickness (optical depth of the cloud over its thickness), at most
    /// 1; 0 or less: not scaled.
    double cloudExtinction_per_m = 0.0;
    std::optional<ModelAtmosphere> atmosphere; ///< decides the cirrus' own base
};

/// An aerosol at the ground, as the air has it: at a wavelength (um) and a relative humidity (0 to
/// 1), relative to its extinction at 0.55 um; wind and air mass as in ParticleSettings.
ParticleOptics aerosolOptics(AerosolModel model, double relativeHumidity, double wavelength_um);

/// Relative humidity (0 to 1, over water) at an altitude in m.
using HumidityProfile = std::function<double(double altitude_m)>;

/// The particles of an atmosphere: boundary layer, free troposphere, stratosphere, above; cloud;
/// rain. Equations, sources and defaults in docs/atmosphere-particles.md. Throws InputError naming
/// each setting out of range (with the report's parameter name as position) and each impossible
/// combination.
std::vector<ParticleLayer> particleLayers(const ParticleSettings& settings,
                                          const HumidityProfile& relativeHumidityAt);
/// The same with the humidity of a profile.
inline std::vector<ParticleLayer> particleLayers(const ParticleSettings& settings,
                                                 const Profile& profile) {
    return particleLayers(settings, [&profile](double altitude_m) {
        return relativeHumidity(profile.at(altitude_m));
    });
}

} // namespace irsg
