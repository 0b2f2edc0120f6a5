#pragma once

#include <filesystem>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "smatcore/tools/PathGeometry.h"

namespace smat::gui {

/// An air and a line of sight in it.
struct AtmospherePreviewQuery {
    irsg::AtmosphereSmartParameters parameters;
    std::filesystem::path file; ///< of the parameters, for the ascent that they may name
    PathGeometryInput path;
    irsg::SunPosition sun;
};

/// What the air does along a line of sight, over the band of its parameters.
struct AtmosphereSpectra {
    std::vector<double> wavelength_um, ///< ascending
        transmittance, pathRadiance_W_m2_sr_um;
    double meanTransmittance = 0.0, inBandPathRadiance_W_m2_sr = 0.0;
};

/// The air up to `profileTop_m`, as the parameters make it.
struct AtmosphereProfile {
    std::vector<double> altitude_km, temperature_C, relativeHumidity_percent;
};
inline constexpr double profileTop_m = 15e3;

/// The spectra of `smat-batch radiative` for the same air and path. Throws irsg::InputError for
/// parameters that cannot be and for a path that there is not.
AtmosphereSpectra atmosphereSpectra(const AtmospherePreviewQuery& query);
/// In steps of 100 m.
AtmosphereProfile atmosphereProfile(const AtmospherePreviewQuery& query);

} // namespace smat::gui
