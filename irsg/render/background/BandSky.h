#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/Environment.h"

namespace irsg {

/// What an environment shows of the sky and the sun in one band, added up at the nodes of a
/// sampling, so that all of a picture is integrated alike.
class BandSky {
  public:
    /// Both must live as long. `raised_rad`: apparent elevations less those that it is asked for,
    /// which are of a flat scene.
    BandSky(const Environment& environment, const SpectralSampling& sampling,
            double raised_rad = 0.0);

    /// What of an answer for the background arrives, by node; nothing: all.
    using Seen = std::function<std::vector<double>(const std::vector<double>&)>;
    void seenThrough(Seen seen) { seen_ = std::move(seen); }

    /// Throws InputError where no atmosphere answers.
    double radiance_W_m2_sr(const LineOfSight& sight) const;
    /// Of the sun on a plane normal to its beam, of the part of its disc above the horizon.
    double sun_W_m2(double altitude_m) const;
    double horizon_rad(double altitude_m) const;
    /// The same in apparent elevations.
    double apparentHorizon_rad(double altitude_m) const;
    SunView sunView(double altitude_m) const;
    const SunPosition& sun() const { return environment_.sun; }

    /// "solar disc: vacuum", each once.
    const std::vector<std::string>& providedBy() const { return providedBy_; }

  private:
    std::vector<double> ask(const char* quantity, const AtmosphericQuery& query) const;

    const Environment& environment_;
    const SpectralSampling& sampling_;
    double raised_rad_;
    Seen seen_;
    mutable std::vector<std::string> providedBy_;
};

} // namespace irsg
