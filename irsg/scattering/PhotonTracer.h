#pragma once

#include <cstdint>
#include <vector>

#include "irsg/scattering/PhaseFunction.h"
#include "irsg/scattering/SmallAngleMtf.h"

namespace irsg {

/// Sums over photons of one batch, by frequency.
struct PhotonSums {
    std::uint64_t photons = 0;
    std::vector<double> sums, squares;

    void add(const PhotonSums& other);
};

/// A mean with its standard error.
struct PhotonEstimate {
    std::vector<double> mtf, standardError;
};

/// Monte Carlo radiative transfer between a sensor and a plane across its line of sight, as an
/// independent witness of the small-angle theory: no angle is taken for small. Photons run from the
/// sensor along its axis through plane-parallel layers (reciprocity: where they meet the target's
/// plane is whence light would come), and scatter by the phase function as often as they happen to;
/// those that leave backwards are lost. A photon that meets the plane at a distance rho from the
/// axis adds J0(2 pi k atan(rho / R)). The first collision is forced and the direct light added
/// exactly, so that thin air needs no more photons than thick. Droplets absorb nothing here: what
/// they absorb weakens direct and scattered light and is the transmittance's.
class PhotonTracer {
  public:
    PhotonTracer(const PhaseFunction& phase, const std::vector<ScatteringLayer>& layers,
                 double opticalDepth, std::vector<double> frequencies_per_rad);

    /// One batch; the same for the same seed and number on every machine with the same floating
    /// point. Batches are independent of each other.
    PhotonSums trace(std::uint64_t seed, std::uint64_t batch, std::uint64_t photons) const;
    PhotonEstimate estimate(const PhotonSums& sums) const;

  private:
    /// Angle from the axis at which a photon meets the target's plane; negative where it never
    /// does.
    template <typename Random>
    double landing_rad(Random& random) const;
    double placeOf(double depth) const;

    PhaseFunction phase_;
    double opticalDepth_;
    std::vector<double> frequencies_per_rad_;
    std::vector<double> depths_, places_; ///< at the borders of the layers, places from 0 to 1
};

} // namespace irsg
