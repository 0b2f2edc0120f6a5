#pragma once

#include <span>
#include <vector>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Wavelengths and weights on which every factor of an in-band integral is sampled, so that
/// products are multiplied spectrally and integrated last. The nodes are Gauss-Legendre points
/// between all the breakpoints of the given spectra, so products of piecewise linear functions are
/// integrated exactly and Planck functions of at least `coldest_K` to about 1e-10 relative.
class SpectralQuadrature {
  public:
    /// `breakpoints`: the spectra whose kinks the grid must respect (may be empty).
    SpectralQuadrature(const Band& band, std::span<const Spectrum* const> breakpoints,
                       double coldest_K = 200.0);

    std::size_t size() const { return wavelengths_um_.size(); }
    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    /// Weights that include the response: sum(w f) = integral of f R over the band.
    const std::vector<double>& weights_um() const { return weights_um_; }

    std::vector<double> sample(const Spectrum& spectrum) const;
    /// Planck radiance at every node, W m-2 sr-1 um-1.
    std::vector<double> planck(double temperature_K) const;
    /// Integral of f R; `values` as many as nodes (LogicError otherwise).
    double integrate(std::span<const double> values) const;
    /// Integral of a b R.
    double integrate(std::span<const double> a, std::span<const double> b) const;

  private:
    std::vector<double> wavelengths_um_;
    std::vector<double> weights_um_;
};

} // namespace irsg
