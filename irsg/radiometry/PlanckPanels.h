#pragma once

#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// A stretch of the spectrum with the number of Gauss-Legendre points that integrates a Planck
/// function times a few linear factors on it to about 1e-11 relative.
struct PlanckPanel {
    SpectralRange range;
    int points = 4;
};

/// Cuts `range` into such panels for black bodies of `coldest_K` and warmer, longest wavelengths
/// first. On a panel the exponent h c / lambda k T changes by at most 4 and the wavelength by at
/// most a factor 1.5. Where the exponent stands more than 150 above its smallest value in the
/// range, and the coldest black body thus emits less than 1e-60 of what it emits elsewhere, the
/// step grows with it, so that a range down to very short wavelengths costs a few hundred panels.
std::vector<PlanckPanel> planckPanels(const SpectralRange& range, double coldest_K);

} // namespace irsg
