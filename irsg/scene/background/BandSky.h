#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"

namespace irsg {

/// What an environment shows of the sky and the sun in one band: spectral quantities summed with
/// given nodes and weights, or wideband ones with the weights of their terms, so that all of a
/// picture is integrated alike.
class BandSky {
  public:
    /// `ck` is null in spectral mode. All must live as long.
    BandSky(const Environment& environment, const SpectralRange& range,
            const std::vector<double>& wavelengths_um, const std::vector<double>& weights_um,
            const SensorCkData* ck);

    /// Throws InputError where no atmosphere answers.
    double radiance_W_m2_sr(const LineOfSight& sight) const;
    /// Of the sun on a plane normal to its beam; 0 for a sun below the horizon.
    double sun_W_m2(double altitude_m) const;
    double horizon_rad(double altitude_m) const;
    const SunPosition& sun() const { return environment_.sun; }

    /// "solar disc: vacuum", each once.
    const std::vector<std::string>& answeredBy() const { return answeredBy_; }

  private:
    double integrate(const std::vector<double>& values) const;
    double integrate(const Spectrum& spectrum) const;
    void note(const char* quantity, const std::string& who) const;

    const Environment& environment_;
    SpectralRange range_;
    const std::vector<double>&wavelengths_um_, &weights_um_;
    const SensorCkData* ck_;
    mutable std::vector<std::string> answeredBy_;
};

} // namespace irsg
