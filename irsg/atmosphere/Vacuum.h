#pragma once

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// No air: transmittance 1, no path radiance, no diffuse flux, a black background. The sun is a
/// black body of 5772 K (IAU 2015 nominal effective temperature) seen under the nominal solar
/// radius (6.957e8 m) at 1 au: solid angle 6.794e-5 sr. Has no ambient temperature of its own.
class Vacuum : public Atmosphere {
  public:
    /// What is seen along an unbounded line of sight: nothing, or nothing that it knows of, where
    /// an environment has a background of its own.
    enum class Background { dark, unknown };
    explicit Vacuum(Background background = Background::dark) : background_(background) {}

    std::string name() const override { return "vacuum"; }
    SpectralRange base() const override { return {0.2, 40.0}; }
    bool supports(AtmosphereProperty property) const override;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;

  private:
    Background background_;
};

/// The sun outside the atmosphere as above, W m-2 um-1 on a plane normal to the beam, times
/// `strength` (of a part of its disc, or from another distance).
Spectrum extraterrestrialSolarIrradiance(const SpectralRange& range, double strength = 1.0);

} // namespace irsg
