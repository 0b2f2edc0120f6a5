#pragma once

#include <complex>
#include <span>
#include <vector>

namespace irsg {

/// How a sphere scatters a plane wave; cross-sections over that of its shadow.
struct MieEfficiencies {
    double extinction = 0.0, scattering = 0.0,
           backscattering = 0.0; ///< the last 4 |S(180)|^2 / x^2
    double asymmetry = 0.0;      ///< mean cosine of the scattering angle
};

/// Amplitudes of the field across and in the plane of scattering (S1, S2).
struct MieAmplitudes {
    std::complex<double> across, along;
};

/// Lorenz-Mie theory of a homogeneous sphere (Bohren and Huffman 1983, chapter 4; Wiscombe 1980,
/// Appl. Opt. 19, 1505), for size parameters x = 2 pi r / lambda from 0.001 to 20,000 and any index
/// n + i k, k >= 0. Stable: the logarithmic derivative inside the sphere and the ratios of the
/// Riccati-Bessel functions psi are recurred downwards, chi upwards, so that nothing overflows or
/// loses its digits, however large x or k are.
class MieSphere {
  public:
    /// LogicError outside these ranges.
    MieSphere(std::complex<double> index, double sizeParameter);

    MieEfficiencies efficiencies() const;
    /// At cosines of the scattering angle, -1 to 1.
    std::vector<MieAmplitudes> amplitudes(std::span<const double> cosines) const;
    std::size_t terms() const { return electric_.size(); }

  private:
    double sizeParameter_;
    std::vector<std::complex<double>> electric_, magnetic_; ///< a_n, b_n from n = 1
};

} // namespace irsg
