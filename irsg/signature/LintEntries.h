#pragma once

#include <vector>

#include "irsg/signature/Findings.h"
#include "irsg/signature/LintScope.h"

namespace irsg {

/// The parts of `lint`, each of which adds its findings.

/// Emissivity, transmissivity, their sum, their axes and N of one material. A band decides
/// between nm and cm-1 where an axis may be either.
void lintMaterial(int index, const Material& material, const std::vector<SpectralRange>& bands,
                  std::vector<Finding>& findings);

/// How a material reflects over directions: n and k, what its emissivity says beside them
/// (Kirchhoff), reflectance over angle (energy), and what has no effect.
void lintSurface(int index, const Material& material, Findings& findings);

/// The terms of eq. 7, their tables, and the temperatures they give at rest and around it.
void lintTerms(int index, const TemperatureEntry& entry, std::vector<Finding>& findings);

/// The user-defined spectrum an entry names, and its component factors.
void lintEmission(int index, const TemperatureEntry& entry, const SignatureDatabase& database,
                  std::vector<Finding>& findings);

/// One user-defined spectrum that is filed under `key`: its form (named components on one shared
/// axis, zero outside) as errors, negative radiance and units that are not likely as warnings.
void lintSpectrum(const std::string& key, const UserSpectrum& spectrum,
                  const std::vector<SpectralRange>& bands, std::vector<Finding>& findings);

/// Codes without an entry, entries and spectra that nothing uses, levels of detail.
void lintUse(const SignatureDatabase& database, const std::vector<ModelUse>& models,
             std::vector<Finding>& findings);

/// Temperatures and tables in the states that analyses sweep.
void lintStates(const SignatureDatabase& database, const std::vector<SweptState>& states,
                std::vector<Finding>& findings);

/// Spectra that do not cover a band.
void lintCoverage(const SignatureDatabase& database, const SpectralRange& band,
                  std::vector<Finding>& findings);

/// What plausible surfaces are, K: at rest in air of 288.15 K, and in any state.
inline constexpr double coldestAtRest_K = 200.0;
inline constexpr double coldestSurface_K = 100.0;
inline constexpr double hottestSurface_K = 4000.0;

} // namespace irsg
