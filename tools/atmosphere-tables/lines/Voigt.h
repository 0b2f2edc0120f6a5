#pragma once

#include <complex>

namespace irsg::lbl {

/// The complex error function w(z) = exp(-z^2) erfc(-i z) for Im z >= 0: rational series of 32
/// terms (Weideman 1994, SIAM J. Numer. Anal. 31, 1497) near the origin, Laplace's continued
/// fraction of three terms where |Re z| + Im z > 10. Its real part is good to 3e-6 of the value
/// where Im z >= 1e-6.
std::complex<double> complexErrorFunction(std::complex<double> z);

/// The Voigt profile with unit area, per cm-1, at a distance from the centre, for half widths at
/// half maximum of its Gaussian (> 0) and Lorentzian (>= 0) parts, all in cm-1; as good as w, and
/// to 1e-12 of the peak for a Gaussian alone.
class VoigtProfile {
  public:
    VoigtProfile(double dopplerWidth_per_cm, double lorentzWidth_per_cm);

    double at(double distance_per_cm) const;
    /// `count` values from `first_per_cm` on in steps of `step_per_cm` times `factor` are added to
    /// `sum`.
    void add(double first_per_cm, double step_per_cm, std::size_t count, double factor,
             double* sum) const;

  private:
    double scale_; ///< sqrt(ln 2) / Doppler width
    double y_;
};

} // namespace irsg::lbl
