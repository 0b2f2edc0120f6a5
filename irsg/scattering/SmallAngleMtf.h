#pragma once

#include <vector>

#include "irsg/scattering/MtfDatabase.h"
#include "irsg/scattering/PhaseFunction.h"

namespace irsg {

/// A part of the path with droplets of one concentration. Layers follow one another from the sensor
/// to the target.
struct ScatteringLayer {
    double thickness = 1.0;     ///< any unit, the same for all, > 0
    double concentration = 1.0; ///< relative, >= 0
};

/// Layers as parts of the path: thicknesses and optical depths each sum to 1. Throws InputError
/// where a number is out of range or nothing scatters.
std::vector<ScatteringLayer> normalised(const std::vector<ScatteringLayer>& layers);

/// Small-angle radiative transfer through layers (docs/scattering.md; R. F. Lutomirski 1978,
/// Appl. Opt. 17, 3915 has the uniform case): light scattered by an angle t at a part s of the way
/// from target to sensor is displaced by s t in the image, so that
///   MTF(k) = exp(tau_s Int_0^1 w(s) P(k s) ds)
/// relative to the direct light, with w the share of the optical depth at s and P the transform of
/// the forward half of the phase function. Light scattered backwards is lost; path lengths are
/// those of the direct light.
class SmallAngleMtf {
  public:
    SmallAngleMtf(const PhaseFunction& phase, const std::vector<ScatteringLayer>& layers,
                  double highestFrequency_per_rad);

    /// The mean of P along the path, by frequency from 0 to the highest.
    double meanTransform(double frequency_per_rad) const;
    MtfCurve curve(double opticalDepth, const std::vector<double>& frequencies_per_rad) const;

  private:
    /// Integral of P from 0.
    double integral(double frequency_per_rad) const;

    std::vector<ScatteringLayer> layers_; ///< normalised
    std::vector<double> nodes_, transforms_, integrals_;
};

/// 0, then `count` - 1 frequencies with equal ratios from `lowest` to `highest`, cycles per radian.
std::vector<double> mtfFrequencies(double lowest, double highest, int count);

} // namespace irsg
