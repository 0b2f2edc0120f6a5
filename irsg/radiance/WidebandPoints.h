#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/atmosphere/AtmosphereIdentity.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

class SensorCkData;

/// The spectra of a scene's surfaces that are not constant over wavelength. Entity by entity, codes
/// ascending, each curve once, however many entries hold it.
struct WidebandSpectra {
    std::vector<Spectrum> materials; ///< emissivities and transmissivities
    std::vector<Spectrum> radiances; ///< components of user-defined spectra
    bool operator==(const WidebandSpectra&) const = default;
};
WidebandSpectra widebandSpectraOf(const std::vector<Entity>& entities);

/// The wideband-ck quadrature points of one environment, band and set of spectra, with the spectra
/// sampled on them: what takes a second to make and does not depend on geometry, temperatures or
/// time.
class WidebandPoints {
  public:
    /// Trains the points to an error of `largestError` (CkRequest). Throws InputError where no
    /// atmosphere has a wideband mode for the band.
    WidebandPoints(const Environment& environment, const Band& band, WidebandSpectra spectra,
                   double largestError = RenderSettings{}.widebandError);

    /// True where these points are those of other arguments, too.
    bool areOf(const Environment& environment, const Band& band, const WidebandSpectra& spectra,
               double largestError) const;

    /// That no environment will ever have the air of these points again.
    bool isGone() const { return atmospheres_.isGone(); }

    const SensorCkData& data() const { return *data_; }
    std::shared_ptr<const SpectralSampling> sampling() const;
    /// Means over the bins of the points.
    std::vector<double> sampled(const Spectrum& spectrum) const;
    /// "wideband-ck: 107 quadrature points, 0.08 % rms and at most 0.4 % off on paths that were not
    /// trained, of AtmosphereSmart (clear.xml)"
    std::string description() const;

  private:
    AtmosphereIdentity atmospheres_;
    SunPosition sun_;
    WidebandSpectra spectra_;
    double largestError_;
    std::shared_ptr<const SensorCkData> data_;
    std::string providedBy_;
    std::vector<std::vector<double>> materialSamples_, radianceSamples_; ///< of spectra_
};

} // namespace irsg
