#pragma once

#include <span>
#include <vector>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralSampling.h"

namespace irsg {

/// Wavelengths and weights on which every factor of an in-band integral is sampled, so that
/// products are multiplied spectrally and integrated last. The nodes are Gauss-Legendre points
/// between all the breakpoints of the given spectra, so products of piecewise linear functions are
/// integrated exactly and Planck functions of at least `coldest_K` to about 1e-10 relative.
class SpectralQuadrature : public SpectralSampling {
  public:
    /// `breakpoints`: the spectra whose kinks the grid must respect (may be empty). Weights include
    /// the response: integrate(f) is the integral of f R over the band.
    SpectralQuadrature(const Band& band, std::span<const Spectrum* const> breakpoints,
                       double coldest_K = 200.0);
};

} // namespace irsg
