#include "irsg/scattering/Mie.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

using Complex = std::complex<double>;

constexpr double smallest = 1e-3, largest = 2e4;
/// Orders from which recurrences start downwards beyond the last that counts.
constexpr int head = 64;

/// Wiscombe's number of terms, with some to spare: the series is complete to rounding.
int termsFor(double x) {
    return static_cast<int>(std::ceil(x + 4.05 * std::cbrt(x) + 8.0));
}

/// D_n(z) = psi_n'(z) / psi_n(z) for n = 0 to `last`: D_{n-1} = n/z - 1 / (D_n + n/z), downwards
/// from beyond |z|, where any start is forgotten.
std::vector<Complex> logarithmicDerivatives(Complex z, int last) {
    const int start = std::max(last, static_cast<int>(std::abs(z))) + head +
                      static_cast<int>(4.0 * std::cbrt(std::abs(z)));
    std::vector<Complex> values(static_cast<std::size_t>(last) + 1);
    Complex here = 0.0;
    for (int n = start; n > 0; --n) {
        const Complex ratio = static_cast<double>(n) / z;
        here = ratio - 1.0 / (here + ratio);
        if (n - 1 <= last)
            values[static_cast<std::size_t>(n) - 1] = here;
    }
    return values;
}

/// psi_n(x) for n = 0 to `last`. Up to n = x it oscillates and is recurred upwards; beyond it falls
/// steeply and follows from the ratios psi_n / psi_{n-1} = 1 / ((2n+1)/x - psi_{n+1} / psi_n),
/// which are recurred downwards.
std::vector<double> psi(double x, int last) {
    std::vector<double> ratios(static_cast<std::size_t>(last) + 2);
    double ratio = 0.0;
    for (int n = last + head + static_cast<int>(4.0 * std::cbrt(x)); n > 0; --n) {
        ratio = 1.0 / ((2.0 * n + 1.0) / x - ratio);
        if (n <= last + 1)
            ratios[static_cast<std::size_t>(n)] = ratio;
    }
    std::vector<double> values(static_cast<std::size_t>(last) + 1);
    values[0] = std::sin(x);
    values[1] = x < 0.1 ? values[0] * ratios[1] : std::sin(x) / x - std::cos(x);
    for (int n = 2; n <= last; ++n) {
        const auto i = static_cast<std::size_t>(n);
        values[i] = n <= x ? (2.0 * n - 1.0) / x * values[i - 1] - values[i - 2]
                           : values[i - 1] * ratios[i];
    }
    return values;
}

} // namespace

MieSphere::MieSphere(Complex index, double sizeParameter) : sizeParameter_(sizeParameter) {
    const double x = sizeParameter;
    if (!(x >= smallest && x <= largest) || !(index.real() >= 0.0) || !(index.imag() >= 0.0) ||
        std::abs(index) == 0.0)
        throw LogicError("a sphere of size parameter " + numberText(x) +
                         " or of this index is outside Mie theory's range");
    const int last = termsFor(x);
    const std::vector<Complex> inside = logarithmicDerivatives(index * x, last);
    const std::vector<double> regular = psi(x, last);
    double chiBelow = std::cos(x), chi = std::cos(x) / x + std::sin(x);
    for (int n = 1; n <= last; ++n) {
        const auto i = static_cast<std::size_t>(n);
        // xi = psi - i chi, outgoing for the time factor exp(-i omega t).
        const Complex xi{regular[i], -chi}, xiBelow{regular[i - 1], -chiBelow};
        const Complex electric = inside[i] / index + n / x;
        const Complex magnetic = inside[i] * index + n / x;
        const Complex a = (electric * regular[i] - regular[i - 1]) / (electric * xi - xiBelow);
        const Complex b = (magnetic * regular[i] - regular[i - 1]) / (magnetic * xi - xiBelow);
        if (!std::isfinite(std::abs(a)) || !std::isfinite(std::abs(b)))
            break; // chi overflows where the terms have vanished long before
        electric_.push_back(a);
        magnetic_.push_back(b);
        const double above = (2.0 * n + 1.0) / x * chi - chiBelow;
        chiBelow = chi;
        chi = above;
    }
}

MieEfficiencies MieSphere::efficiencies() const {
    double extinction = 0.0, scattering = 0.0, asymmetry = 0.0;
    Complex back = 0.0;
    for (std::size_t i = 0; i < electric_.size(); ++i) {
        const auto n = static_cast<double>(i + 1);
        const Complex a = electric_[i], b = magnetic_[i];
        extinction += (2.0 * n + 1.0) * (a + b).real();
        scattering += (2.0 * n + 1.0) * (std::norm(a) + std::norm(b));
        back += (2.0 * n + 1.0) * (i % 2 == 0 ? -1.0 : 1.0) * (a - b);
        asymmetry += (2.0 * n + 1.0) / (n * (n + 1.0)) * (a * std::conj(b)).real();
        if (i + 1 < electric_.size())
            asymmetry += n * (n + 2.0) / (n + 1.0) *
                         (a * std::conj(electric_[i + 1]) + b * std::conj(magnetic_[i + 1])).real();
    }
    const double x2 = sizeParameter_ * sizeParameter_;
    return {2.0 / x2 * extinction, 2.0 / x2 * scattering, std::norm(back) / x2,
            2.0 * asymmetry / scattering};
}

std::vector<MieAmplitudes> MieSphere::amplitudes(std::span<const double> cosines) const {
    std::vector<MieAmplitudes> result;
    for (const double cosine : cosines) {
        // pi_n and tau_n of Bohren and Huffman, eq. 4.47, upwards.
        MieAmplitudes sum{};
        double below = 0.0, here = 1.0;
        for (std::size_t i = 0; i < electric_.size(); ++i) {
            const auto n = static_cast<double>(i + 1);
            const double along = n * cosine * here - (n + 1.0) * below;
            const double weight = (2.0 * n + 1.0) / (n * (n + 1.0));
            sum.across += weight * (electric_[i] * here + magnetic_[i] * along);
            sum.along += weight * (electric_[i] * along + magnetic_[i] * here);
            const double above = ((2.0 * n + 1.0) * cosine * here - (n + 1.0) * below) / n;
            below = here;
            here = above;
        }
        result.push_back(sum);
    }
    return result;
}

} // namespace irsg
