#pragma once

#include <vector>

#include "irsg/scattering/MtfDatabase.h"

namespace irsg {

/// The light that scattering spreads around a point, as a function of the angle from it: the
/// two-dimensional Fourier transform (a Hankel transform) of H = MTF - MTF(infinity). The direct
/// image is left out, so that a point stays a point. MTF(infinity) is the curve's last value.
///
/// H is followed by straight pieces, eight in each interval of the curve. With slopes s_i and
/// a = 2 pi theta, integration by parts leaves one integral, that of J0:
///   h(theta) = 2 pi / a^2 sum_i s_i [f J0(a f) - (1/a) Int_0^{a f} J0]  over the ends of piece i
///   E(theta) = H(0) + 1/a sum_i s_i [Int_0^{a f} J0]
/// which is exact at any angle, however often J0 oscillates within a piece.
class HazeFunction {
  public:
    explicit HazeFunction(const MtfCurve& curve);

    /// Energy of the whole haze, MTF(0) - MTF(infinity).
    double energy() const { return energy_; }
    /// Per steradian (small angles), > 0 angles.
    double density_sr(double angle_rad) const;
    /// Energy nearer to the point than an angle.
    double energyWithin(double angle_rad) const;
    double highestFrequency_per_rad() const { return frequencies_.back(); }
    /// The curve is cut off while it still falls, so that the density has rings of the highest
    /// frequency.
    bool endsSharply() const;

  private:
    std::vector<double> frequencies_; ///< ends of the pieces
    std::vector<double> turns_;       ///< by end: slope before less slope behind
    double energy_ = 0.0;
};

} // namespace irsg
