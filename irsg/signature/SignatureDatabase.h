#pragma once

#include <map>
#include <string>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/ComponentFactors.h"
#include "irsg/signature/ReflectanceTable.h"
#include "irsg/signature/TemperatureTerms.h"
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

/// Facets are not smoother: the sun's disc is wider than what they would show of it.
inline constexpr double leastRoughness = 0.001;

/// What stands behind one material index (IRMaterial) of a model. Reflectivity is derived:
/// rho = 1 - emissivity - transmissivity.
struct Material {
    std::string name;
    Spectrum emissivity = Spectrum::constant(1.0);
    Spectrum transmissivity;   ///< grey or spectral, 0 for opaque
    double nAngleFactor = 0.0; ///< N of cos^N(theta_view), >= 0
    std::string notes;
    /// How it reflects over directions (see SurfaceModel); empty: Lambertian. With facets,
    /// emissivity is that along the normal, with Sandford and Robertson's model the hemispherical.
    std::string surfaceModel = {};
    double roughness = 0.2; ///< alpha of the model's facets, 0.001 to 1
    /// n and k of its bulk, in place of the emissivity, for a surface with facets; 0: unknown.
    Spectrum refractiveIndex = {}, extinction = {};
    /// rho_D and rho_V of the models that have them.
    Spectrum diffuseReflectivity = {}, volumeReflectivity = {};
    double grazingFactor = 0.3; ///< b of Sandford and Robertson, 0 to 1
    /// Of Maxwell and Beard's shadowing.
    double shadowTau_deg = 15.0, shadowOmega_deg = 40.0;
    ReflectanceTable reflectanceTable = {}; ///< of the model "tabulated"
    /// Total pressure of a gas that fills closed meshes of this material, atm; 0: a surface. It has
    /// the temperature of their faces; the spectra above say nothing of it.
    double gasPressure_atm = 0.0;
    /// Its mole fractions; the rest is nitrogen.
    double gasCO2 = 0.0, gasH2O = 0.0, gasCO = 0.0, gasCH4 = 0.0, gasO2 = 0.0;
    double gasSoot_ppmv = 0.0; ///< volume fraction of soot times 1e6

    bool isGas() const { return gasPressure_atm > 0.0; }
    bool isOpaque() const { return !isGas() && transmissivity.maximum() <= 0.0; }
    /// Whether its model takes n and k.
    bool hasIndex() const {
        return !surfaceModel.empty() && surfaceModel != "sandfordRobertson" &&
               surfaceModel != "tabulated" && refractiveIndex.maximum() > 0.0;
    }
    /// 1 - emissivity - transmissivity.
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

} // namespace irsg
