#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/radiance/RadianceTerms.h"
#include "irsg/radiance/SharedValues.h"
#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// The air between one place of an object and the sensor, on the nodes of a sampling.
struct AtmosphereSamples {
    SharedValues transmittance;
    /// By term of a RadianceTerms: what the air sends in it, W m-2 sr-1 um-1 into the path or
    /// W m-2 um-1 onto the object; null for a term without light, and where it is off.
    std::vector<SharedValues> light;
    bool operator==(const AtmosphereSamples& other) const {
        return areEqual(transmittance, other.transmittance) &&
               std::ranges::equal(light, other.light, areEqual);
    }
};

/// One surface and what it is doing.
struct SurfaceInput {
    const TemperatureEntry* temperature = nullptr;
    const Material* material = nullptr;
    const UserSpectrum* userSpectrum = nullptr; ///< of the entry, in the second mode
    EntityState state;
    double temperature_K = 0.0;   ///< with its scaling; 0 for a user-defined spectrum
    double emissivityScale = 1.0; ///< multiplies the emission; emissivity is kept at most 1 - t
    /// Transmittance from the source to the spectrum's reference distance; empty where that is 0.
    std::vector<double> referenceTransmittance;
    /// The sensor is not farther than the reference distance: the measurement is taken as it is.
    bool insideReference = false;
};

/// What a surface's own properties make of the terms of RadianceTerms, at the surface (report eqs.
/// 1 to 3, 6; corrected as docs/physics.md says). A term is a surface quantity times light, times
/// tau where the light passes the air:
///   emission:    epsilon L_bb(T), or sum of c_j L_j / tau_ref for a user-defined spectrum
///   reflectance: rho / pi
///   opacity:     1 - t
/// Emission and reflection are not multiplied by 1 - t again: epsilon + rho + t = 1 already.
struct SurfaceSpectra {
    /// A body emits one part, of factor 1; a measured spectrum one of each component L_j, whose
    /// factor c_j alone depends on time and aspect.
    struct Emission {
        double factor = 1.0;
        std::vector<double> radiance; ///< W m-2 sr-1 um-1 at a factor of 1
    };
    std::vector<Emission> emission;
    /// The radiance of the air that a lobe reflects, W m-2 sr-1 um-1, and how much of it: one for
    /// all places of the air. Null for others.
    SharedValues lobeLight, lobeAmount;
    /// Reflectance counts for what other surfaces send alone, and no term has it.
    bool reflectsSurfacesAlone = false;
    /// A gas: what it sends and hides is that of a black body times the part of the light that a
    /// column of it takes away (GasColumnSpectra).
    bool isGas = false;
    bool emissionPassesAtmosphere = true; ///< false: measured from farther away, with all its air
    std::vector<double> reflectance, opacity; ///< empty: 0
    std::vector<double> transmissivity;
    std::vector<double> emissivity; ///< of the material, before any scaling
    /// Of directional surfaces and their lobes, how both depend on a scale e of the emissivity:
    /// reflectivity is `reflectsAtMost` - e times `emissivity`, and what is emitted beside that
    /// emissivity, whatever the scale, is `emitsAlways`, which may be negative. Empty for others,
    /// which reflect 1 - t at most and emit nothing else.
    std::vector<double> reflectsAtMost, emitsAlways;
    double nAngleFactor = 0.0;
    double temperature_K = 0.0; ///< of the surface; 0 for a user-defined spectrum

    double absorbsAtMost(std::size_t node) const {
        return reflectsAtMost.empty() ? 1.0 - transmissivity[node] : reflectsAtMost[node];
    }
    bool isTransparent() const {
        return std::ranges::any_of(transmissivity, [](double t) { return t > 0.0; });
    }
    /// Nothing is sent in terms of that quantity.
    bool isWithout(SurfaceQuantity quantity) const;
    /// The reflectance, the opacity or the amount of a lobe, which the last multiplies its light
    /// with; LogicError for emission, which has parts.
    const std::vector<double>& quantity(SurfaceQuantity quantity) const;
};

/// How a directional surface reflects on the nodes of a sampling: the amounts of its components
/// with the scale of its emissivity, and what another scale of 1 would take off them.
struct DirectionalSpectra {
    std::shared_ptr<const SurfaceModel> model; ///< null for a Lambertian surface: no more is known
    std::vector<SurfaceModel::Amounts> amounts, perScale;
    /// 1 - t less what is reflected over the hemisphere.
    std::vector<double> emissivity;
};

/// How a spectrum is brought to the wavelengths of a calculation: its values there, or its means
/// over what each of them stands for.
using SpectrumSampler = std::function<std::vector<double>(const Spectrum&)>;

DirectionalSpectra directionalSpectra(const SurfaceInput& surface, const SpectrumSampler& sample);

/// All vectors as long as `wavelengths_um`. A directional surface is the Lambertian one of equal
/// hemispherical reflectance; the rest are its lobes. The temperature must be positive (LogicError:
/// the scene check names the entry).
SurfaceSpectra surfaceSpectra(const SurfaceInput& surface,
                              const std::vector<double>& wavelengths_um,
                              const SpectrumSampler& sample,
                              const DirectionalSpectra& directional = {});

/// One component of a directional surface beside the Lambertian one: it reflects its amount, and
/// emits less by that.
SurfaceSpectra lobeSpectra(const SurfaceSpectra& whole, const DirectionalSpectra& directional,
                           std::size_t component, const std::vector<double>& wavelengths_um);

/// The same component as it reflects radiance of the air from one direction: it does not emit. Only
/// `light`, W m-2 sr-1 um-1, differs between directions; how it scales is what the component itself
/// says.
SurfaceSpectra specularSpectra(const SurfaceSpectra& whole, SharedValues amount,
                               SharedValues light);
/// The same component as it reflects what other surfaces send along its lobe: no term has it, and
/// how it scales is what the component itself says.
SurfaceSpectra surfacesReflection(SurfaceSpectra component);
/// By component.
std::vector<SharedValues> lobeAmounts(const DirectionalSpectra& directional);

/// c_j of eq. 6 times the calibration, by component of a user-defined spectrum.
std::vector<double> componentFactors(const SurfaceInput& surface);

/// Apparent spectral radiance of a surface at the sensor in term `number` of a list at a geometric
/// factor of 1, W m-2 sr-1 um-1; empty where the term is off or the surface sends nothing in it.
std::vector<double> apparentTerm(const SurfaceSpectra& surface, const RadianceTerms& terms,
                                 std::size_t number, const AtmosphereSamples& air);

} // namespace irsg
