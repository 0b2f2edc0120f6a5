#pragma once

#include <map>
#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/ComponentFactors.h"
#include "irsg/signature/SurfaceTemperature.h"
#include "irsg/signature/UserSpectrum.h"

namespace irsg {

enum class EmissionMode {
    temperature, ///< grey or spectral emission of a surface at the temperature of eq. 7
    userSpectrum ///< sum of the factors times the components of a user-defined spectrum, eq. 6
};

/// What stands behind one temperature index (IRColor) of a model.
struct TemperatureEntry {
    std::string name;
    EmissionMode mode = EmissionMode::temperature;
    TemperatureTerms terms;   ///< kept in both modes, used in the first
    std::string userSpectrum; ///< name of a user-defined spectrum, used in the second
    ComponentFactors factors; ///< components without a factor count with 1
    std::string notes;        ///< provenance: where the numbers come from

    bool operator==(const TemperatureEntry&) const = default;
};

/// What stands behind one material index (IRMaterial) of a model. Reflectivity is derived:
/// rho = 1 - emissivity - transmissivity.
struct Material {
    std::string name;
    Spectrum emissivity = Spectrum::constant(1.0);
    Spectrum transmissivity;   ///< grey or spectral, 0 for opaque
    double nAngleFactor = 0.0; ///< N of cos^N(theta_view), >= 0
    std::string notes;

    bool isOpaque() const { return transmissivity.maximum() <= 0.0; }
    double reflectivityAt(double wavelength_um) const;
    bool operator==(const Material&) const = default;
};

/// The signature of one 3-D model: a value, copied and compared like one. Index 0 (a face without a
/// code) is an ordinary entry.
struct SignatureDatabase {
    std::string title;
    std::string notes;
    std::map<int, TemperatureEntry> temperatures;
    std::map<int, Material> materials;
    std::map<std::string, UserSpectrum> spectra;

    bool operator==(const SignatureDatabase&) const = default;
};

/// The lookup tables that hold an end value in this state because their axis does not reach it:
/// "temperatures.4.terms.power". Only what the mode of an entry uses counts. Whoever runs an
/// analysis warns of each once.
std::vector<std::string> tablesHeld(const SignatureDatabase& database, const EntityState& state);

} // namespace irsg
