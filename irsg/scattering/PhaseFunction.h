#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "irsg/scattering/SizeDistribution.h"

namespace irsg {

/// Where unpolarised light goes that a droplet scatters: per steradian, its integral over all
/// directions is 1. Linear between its angles.
class PhaseFunction {
  public:
    /// Angles from 0 to pi ascend; the values are normalised. LogicError for anything else.
    PhaseFunction(std::vector<double> angles_rad, std::vector<double> values);

    /// (1 - g^2) / (4 pi (1 + g^2 - 2 g cos t)^(3/2)), of L. G. Henyey and J. L. Greenstein 1941,
    /// Astrophys. J. 93, 70. InputError for an asymmetry g beyond -0.98 to 0.98.
    static PhaseFunction henyeyGreenstein(double asymmetry);

    const std::vector<double>& angles_rad() const { return angles_rad_; }
    double at(double angle_rad) const;
    double asymmetry() const;
    /// Part that goes forward, below 90 degrees.
    double forwardFraction() const;

    /// Transform of the forward half, 2 pi Int_0^{pi/2} p(t) J0(2 pi k t) sin t dt, k >= 0 in
    /// cycles per radian; at 0 it is the forward share.
    double transform(double frequency_per_rad) const;

    /// Cosine of the scattering angle below which a part `u` (0 to 1) of the light goes.
    double cosineAt(double u) const;

  private:
    std::vector<double> angles_rad_, values_;
    std::vector<double> below_; ///< share scattered by less than each angle
    // Of the transform: p sin t / t at the angles of the forward half, as HazeFunction has it.
    std::vector<double> forwardAngles_, turns_;
    double atEnd_ = 0.0;
};

/// Mean optics of droplets.
struct DropletOptics {
    PhaseFunction phase;
    double extinction_um2 = 0.0, scattering_um2 = 0.0; ///< mean cross-sections of a droplet
    double albedo() const { return scattering_um2 / extinction_um2; }
};

/// Mie theory of spheres of index n + i k over a size distribution. Angles are as dense as the
/// rings of the largest droplet need. `tell` is told the part that is done, 0 to 1, and stops the
/// work where it says false: an empty result is thrown as Cancelled.
DropletOptics dropletOptics(const SizeDistribution& sizes, std::complex<double> index,
                            double wavelength_um, const std::function<bool(double)>& tell = {});

/// Thrown where somebody asked to stop.
struct Cancelled {};

} // namespace irsg
