#include "irsg/atmosphere/lbl/Voigt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace irsg::lbl {

namespace {

constexpr int terms = 32;
constexpr double rootPi = 1.7724538509055160273;
constexpr double farAway = 15.0;

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

/// Real part of i z / (sqrt(pi) (z^2 - 1/2)).
inline double asymptotic(double x, double y) {
    const double a = x * x - y * y - 0.5, b = 2.0 * x * y;
    return y * (x * x + y * y + 0.5) / ((a * a + b * b) * rootPi);
}

} // namespace

std::complex<double> complexErrorFunction(std::complex<double> z) {
    constexpr std::complex<double> i(0.0, 1.0);
    if (std::abs(z.real()) + z.imag() > farAway)
        return i * z / (rootPi * (z * z - 0.5));
    const Weideman& w = weideman();
    const std::complex<double> below = w.L - i * z;
    const std::complex<double> ratio = (w.L + i * z) / below;
    std::complex<double> polynomial = 0.0;
    for (const double a : w.a)
        polynomial = polynomial * ratio + a;
    return 2.0 * polynomial / (below * below) + 1.0 / (rootPi * below);
}

VoigtProfile::VoigtProfile(double dopplerWidth_cm, double lorentzWidth_cm)
    : scale_(std::sqrt(std::numbers::ln2) / dopplerWidth_cm), y_(scale_ * lorentzWidth_cm) {}

double VoigtProfile::at(double distance_cm) const {
    return scale_ / rootPi * complexErrorFunction({scale_ * distance_cm, y_}).real();
}

void VoigtProfile::add(double first_cm, double step_cm, std::size_t count, double factor,
                       double* sum) const {
    const double scaled = factor * scale_ / rootPi;
    const double x0 = scale_ * first_cm, dx = scale_ * step_cm;

    // The stretch of points that are not far away, if any, is summed exactly; the rest in two
    // sweeps.
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
            sum[i] += scaled * asymptotic(x0 + dx * static_cast<double>(i), y_);
    };
    sweep(0, begin);
    for (std::size_t i = begin; i < end; ++i)
        sum[i] += scaled * complexErrorFunction({x0 + dx * static_cast<double>(i), y_}).real();
    sweep(end, count);
}

} // namespace irsg::lbl
