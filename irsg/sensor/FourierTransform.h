#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace irsg {

/// The discrete Fourier transform of real numbers on a grid: sum of f exp(-2 pi i (k x / width +
/// l y / height)). Frequencies 0 to width / 2 along the rows, for each of `height` along the
/// columns; the others are the conjugates of these.
template <typename Real>
struct HalfSpectrumOf {
    HalfSpectrumOf(std::size_t columns, std::size_t rows)
        : width(columns), height(rows), values((columns / 2 + 1) * rows) {}

    std::size_t columns() const { return width / 2 + 1; }

    std::size_t width, height; ///< of the grid
    std::vector<std::complex<Real>> values;
};

using HalfSpectrum = HalfSpectrumOf<double>;

/// The least number from `size` on with no prime factor but 2, 3 and 5; at least 1.
std::size_t smoothSize(std::size_t size);

/// Of width x height numbers, row by row (at least one; LogicError for another number of them).
/// Quick where sides have the factors 2, 3 and 5 alone. The result does not depend on the number of
/// threads.
HalfSpectrum transformOf(const std::vector<double>& values, std::size_t width, std::size_t height);
HalfSpectrumOf<float> transformOf(const std::vector<float>& values, std::size_t width,
                                  std::size_t height);
/// The numbers of which this is the transform.
std::vector<double> transformBack(HalfSpectrum spectrum);
std::vector<float> transformBack(HalfSpectrumOf<float> spectrum);

} // namespace irsg
