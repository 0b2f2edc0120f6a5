#include "tools/atmosphere-tables/lines/Voigt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace irsg::lbl {

namespace {

constexpr int terms = 32;
constexpr double rootPi = 1.7724538509055160273;
constexpr double farAway = 10.0; ///< |x| + y beyond which the continued fraction serves

/// Weideman's coefficients, highest power first, and his parameter L.
struct Weideman {
    double L = std::sqrt(terms / std::numbers::sqrt2);
    std::array<double, terms> a{};

    Weideman() {
        // Fourier coefficients of f(theta) = exp(-t^2) (L^2 + t^2), t = L tan(theta / 2), by the
        // trapezoidal rule, which converges fast for a periodic function.
        constexpr int half = 2 * terms;
        for (int n = 1; n <= terms; ++n) {
            double sum = 0.0;
            for (int k = -half + 1; k < half; ++k) {
                const double theta = std::numbers::pi * k / half;
                const double t = L * std::tan(0.5 * theta);
                sum += std::exp(-t * t) * (L * L + t * t) * std::cos(n * theta);
            }
            a[static_cast<std::size_t>(terms - n)] = sum / (2 * half);
        }
    }
};

const Weideman& weideman() {
    static const Weideman coefficients;
    return coefficients;
}

/// Re w(x + i y) far away: Laplace's continued fraction cut after three terms,
/// w = i z (z^2 - 5/2) / (sqrt(pi) (z^4 - 3 z^2 + 3/4)), written out for its real part.
inline double farReal(double x, double y) {
    const double a = x * x - y * y, b = 2.0 * x * y; // z^2
    const double upperReal = x * (a - 2.5) - y * b, upperImaginary = x * b + y * (a - 2.5);
    const double lowerReal = a * a - b * b - 3.0 * a + 0.75, lowerImaginary = b * (2.0 * a - 3.0);
    return (upperReal * lowerImaginary - upperImaginary * lowerReal) /
           ((lowerReal * lowerReal + lowerImaginary * lowerImaginary) * rootPi);
}

/// Points that are summed side by side, so that compilers make vectors of them.
constexpr std::size_t lanes = 8;

/// Re w at x0, x0 + dx, ... by Weideman's series.
std::array<double, lanes> nearReal(const Weideman& w, double x0, double dx, double y) {
    std::array<double, lanes> result, belowReal, belowImaginary, ratioReal, ratioImaginary;
    std::array<double, lanes> sumReal{}, sumImaginary{};
    for (std::size_t k = 0; k < lanes; ++k) {
        // 1 / (L - i z) and (L + i z) / (L - i z)
        const double x = x0 + dx * static_cast<double>(k), plus = w.L + y;
        const double norm = 1.0 / (plus * plus + x * x);
        belowReal[k] = plus * norm;
        belowImaginary[k] = x * norm;
        ratioReal[k] = (w.L - y) * belowReal[k] - x * belowImaginary[k];
        ratioImaginary[k] = (w.L - y) * belowImaginary[k] + x * belowReal[k];
    }
    for (const double a : w.a)
        for (std::size_t k = 0; k < lanes; ++k) {
            const double real = sumReal[k] * ratioReal[k] - sumImaginary[k] * ratioImaginary[k] + a;
            sumImaginary[k] = sumReal[k] * ratioImaginary[k] + sumImaginary[k] * ratioReal[k];
            sumReal[k] = real;
        }
    for (std::size_t k = 0; k < lanes; ++k) {
        const double squareReal =
            belowReal[k] * belowReal[k] - belowImaginary[k] * belowImaginary[k];
        const double squareImaginary = 2.0 * belowReal[k] * belowImaginary[k];
        result[k] = 2.0 * (sumReal[k] * squareReal - sumImaginary[k] * squareImaginary) +
                    belowReal[k] / rootPi;
    }
    return result;
}

} // namespace

std::complex<double> complexErrorFunction(std::complex<double> z) {
    constexpr std::complex<double> i(0.0, 1.0);
    const std::complex<double> square = z * z;
    if (std::abs(z.real()) + z.imag() > farAway)
        return i * z * (square - 2.5) / (rootPi * (square * (square - 3.0) + 0.75));
    const Weideman& w = weideman();
    const std::complex<double> below = w.L - i * z;
    const std::complex<double> ratio = (w.L + i * z) / below;
    std::complex<double> polynomial = 0.0;
    for (const double a : w.a)
        polynomial = polynomial * ratio + a;
    return 2.0 * polynomial / (below * below) + 1.0 / (rootPi * below);
}

VoigtProfile::VoigtProfile(double dopplerWidth_per_cm, double lorentzWidth_per_cm)
    : scale_(std::sqrt(std::numbers::ln2) / dopplerWidth_per_cm),
      y_(scale_ * lorentzWidth_per_cm) {}

double VoigtProfile::at(double distance_per_cm) const {
    const double x = scale_ * distance_per_cm;
    const double real =
        std::abs(x) + y_ > farAway ? farReal(x, y_) : complexErrorFunction({x, y_}).real();
    return scale_ / rootPi * real;
}

void VoigtProfile::add(double first_per_cm, double step_per_cm, std::size_t count, double factor,
                       double* sum) const {
    const double scaled = factor * scale_ / rootPi;
    const double x0 = scale_ * first_per_cm, dx = scale_ * step_per_cm;

    // The stretch of points that are not far away, if any, lies between two that are.
    const double reach = farAway - y_;
    std::size_t begin = count, end = count;
    if (reach > 0.0) {
        begin = static_cast<std::size_t>(
            std::clamp(std::ceil((-reach - x0) / dx), 0.0, static_cast<double>(count)));
        end = static_cast<std::size_t>(
            std::clamp(std::floor((reach - x0) / dx) + 1.0, 0.0, static_cast<double>(count)));
        end = std::max(begin, end);
    }
    auto sweep = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            sum[i] += scaled * farReal(x0 + dx * static_cast<double>(i), y_);
    };
    sweep(0, begin);
    for (std::size_t i = begin; i < end; i += lanes) {
        const auto values = nearReal(weideman(), x0 + dx * static_cast<double>(i), dx, y_);
        const std::size_t some = std::min(lanes, end - i);
        for (std::size_t k = 0; k < some; ++k)
            sum[i + k] += scaled * values[k];
    }
    sweep(end, count);
}

} // namespace irsg::lbl
