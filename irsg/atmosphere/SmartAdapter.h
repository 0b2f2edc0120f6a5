#pragma once

#include <filesystem>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"

namespace irsg {

/// Between the report's parameters and the engine (F16): degrees C to K, mbar to hPa, % to
/// fractions, codes to kinds. Geometry is the same on both sides (AtmosphericPath, LineOfSight: m,
/// rad, East of North, up positive).
class SmartAdapter {
  public:
    /// The whole description of air and ground. `file` is where the parameters came from, for the
    /// path of a radiosonde ascent. Throws InputError as diagnosticsOf() names them, and for an
    /// ascent that cannot be used.
    static AtmosphericModel atmosphericModel(const AtmosphereSmartParameters& parameters,
                                             const std::filesystem::path& file = {});

    /// The model atmosphere or the ascent, its lowest kilometre reshaped in MeteoModel 2.
    static Profile profile(const AtmosphereSmartParameters& parameters,
                           const std::filesystem::path& file = {});
    /// Aerosol, cloud and rain. High aerosols are those of autumn and winter in the winter models 3
    /// and 5 (as MODTRAN's ISEASN 0); place and extinction of a cloud that is not there are
    /// dropped.
    static ParticleSettings particleSettings(const AtmosphereSmartParameters& parameters);
    /// Linear between the wavelengths, clamped outside them.
    static Spectrum groundAlbedo(const AtmosphereSmartParameters& parameters);
};

} // namespace irsg
