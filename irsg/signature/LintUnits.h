#pragma once

#include <optional>
#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/UserSpectrum.h"

namespace irsg {

/// A grey body, emissivity times Planck's law, laid through a curve of radiance.
struct GreyBody {
    double temperature_K = 0.0;
    double emissivity = 0.0;
    double misfit = 0.0; ///< root mean square of ln(curve / grey body)
};

/// The grey body of least misfit; no value for fewer than five nodes, for a curve that is not above
/// 0 throughout, and for one that no temperature fits. With x = c2 / (lambda T),
///   ln(c1 / (lambda^5 L)) = -ln(emissivity) + x + ln(1 - exp(-x))
/// is solved by straight lines in 1 / lambda, the last term taken from the temperature before.
std::optional<GreyBody> fitGreyBody(const std::vector<double>& wavelengths_um,
                                    const std::vector<double>& radiance_W_m2_sr_um);

/// Warns of radiance that no likely source has, with the unit that would explain it: curves that
/// are those of a grey body with an emissivity of 0.001 to 1 in another unit only (per cm-1 in
/// place of per um, W cm-2 in place of W m-2); and brightness temperatures, judged at their peak
/// because between the lines of a gas any is right, outside 200 to 4000 K.
void lintRadianceUnit(const std::string& key, const UserSpectrum& spectrum, std::size_t component,
                      Findings& findings);

/// Warns of an axis that is not one of the infrared, with the unit that would explain it. The
/// repair converts the densities anew where the imported unit was per cm-1. Returns whether it
/// warned: then brightness says nothing.
bool lintSpectrumAxis(const std::string& key, const UserSpectrum& spectrum,
                      const std::vector<SpectralRange>& bands, Findings& findings);

} // namespace irsg
