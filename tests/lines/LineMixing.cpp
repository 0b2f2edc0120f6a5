#include "tests/lines/LineMixing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "tools/atmosphere-tables/lines/LineAbsorption.h"

namespace irsg::lbl {

namespace {

constexpr int highest = 110; ///< J
// 12C16O2, cm-1: ground state, 00011 and their distance (L. S. Rothman et al. 1992, J. Quant.
// Spectrosc. Radiat. Transfer 48, 537).
constexpr double lowerB = 0.39021889, lowerD = 1.333e-7, upperB = 0.38714044, upperD = 1.330e-7,
                 origin_per_cm = 2349.1429;

double lnFactorial(int n) {
    return std::lgamma(n + 1.0);
}

double level_per_cm(int J, double B, double D) {
    const double x = J * (J + 1.0);
    return x * (B - D * x);
}

bool isTriangle(int a, int b, int c) {
    return c >= std::abs(a - b) && c <= a + b;
}

double lnTriangle(int a, int b, int c) {
    return 0.5 * (lnFactorial(a + b - c) + lnFactorial(a - b + c) + lnFactorial(-a + b + c) -
                  lnFactorial(a + b + c + 1));
}

/// What is left of a rate as the molecule turns on from J during the collision.
double adiabatic(int J, const CollisionLaw& law, double temperature_K) {
    if (J < 2) {
        return 1.0;
    }
    const double speed_m_s = std::sqrt(8.0 * 8.314462618 * temperature_K /
                                       (std::numbers::pi * law.reducedMass_g * 1e-3));
    const double turn_per_s =
        2.0 * std::numbers::pi * 2.99792458e10 *
        (level_per_cm(J, lowerB, lowerD) - level_per_cm(J - 2, lowerB, lowerD));
    const double x = turn_per_s * law.length_m / speed_m_s;
    return std::pow(1.0 + x * x / 24.0, -2.0);
}

} // namespace

double wigner3j(int a, int b, int c) {
    const int sum = a + b + c, half = sum / 2;
    if (sum % 2 != 0 || !isTriangle(a, b, c)) {
        return 0.0;
    }
    const double ln = 0.5 * (lnFactorial(sum - 2 * a) + lnFactorial(sum - 2 * b) +
                             lnFactorial(sum - 2 * c) - lnFactorial(sum + 1)) +
                      lnFactorial(half) - lnFactorial(half - a) - lnFactorial(half - b) -
                      lnFactorial(half - c);
    return (half % 2 == 0 ? 1.0 : -1.0) * std::exp(ln);
}

double wigner6j(int a, int b, int c, int d, int e, int f) {
    if (!isTriangle(a, b, c) || !isTriangle(a, e, f) || !isTriangle(d, b, f) ||
        !isTriangle(d, e, c)) {
        return 0.0;
    }
    const double ln =
        lnTriangle(a, b, c) + lnTriangle(a, e, f) + lnTriangle(d, b, f) + lnTriangle(d, e, c);
    const int first = std::max({a + b + c, a + e + f, d + b + f, d + e + c});
    const int last = std::min({a + b + d + e, b + c + e + f, c + a + f + d});
    double sum = 0.0;
    for (int z = first; z <= last; ++z) {
        sum += (z % 2 == 0 ? 1.0 : -1.0) *
               std::exp(ln + lnFactorial(z + 1) - lnFactorial(z - a - b - c) -
                        lnFactorial(z - a - e - f) - lnFactorial(z - d - b - f) -
                        lnFactorial(z - d - e - c) - lnFactorial(a + b + d + e - z) -
                        lnFactorial(b + c + e + f - z) - lnFactorial(c + a + f + d - z));
    }
    return sum;
}

LineMixing::LineMixing(const LineList& list, double temperature_K, double pressure_atm,
                       const std::vector<CollisionLaw>& laws)
    : temperature_K_(temperature_K), pressure_atm_(pressure_atm) {
    const double kT_per_cm = temperature_K / secondRadiationConstant_cm_K;
    for (int J = 0; J <= highest; J += 2) {
        for (const int upper : {J - 1, J + 1}) {
            if (upper < 0) {
                continue;
            }
            const double lower_per_cm = level_per_cm(J, lowerB, lowerD);
            const double centre_per_cm =
                origin_per_cm + level_per_cm(upper, upperB, upperD) - lower_per_cm;
            const Line* found = nullptr;
            for (auto line = std::ranges::lower_bound(list.lines, centre_per_cm - 0.05, {},
                                                      &Line::wavenumber_per_cm);
                 line != list.lines.end() && line->wavenumber_per_cm < centre_per_cm + 0.05;
                 ++line) {
                if (line->isotopologue == 1 &&
                    std::abs(line->lowerEnergy_per_cm - lower_per_cm) < 1.0 &&
                    (!found || line->intensity > found->intensity)) {
                    found = &*line;
                }
            }
            if (!found) {
                continue;
            }
            Transition transition{J, upper, found->wavenumber_per_cm, 0.0, 0.0, 0.0, 0.0};
            transition.population = (2 * J + 1) * std::exp(-lower_per_cm / kT_per_cm);
            transition.intensity =
                found->intensity * std::exp(-secondRadiationConstant_cm_K * lower_per_cm *
                                            (1.0 / temperature_K - 1.0 / referenceTemperature_K));
            transition.dipole = std::sqrt(transition.intensity / transition.population);
            transition.width_per_cm = static_cast<double>(found->airWidth_cm_atm) *
                                      std::pow(referenceTemperature_K / temperature_K,
                                               static_cast<double>(found->widthExponent));
            lines_.push_back(transition);
        }
    }
    const std::size_t n = lines_.size();
    matrix_.assign(n * n, 0.0);
    for (const CollisionLaw& law : laws) {
        std::array<double, 2 * highest + 4> rate{}, turn{};
        for (int L = 0; L < static_cast<int>(rate.size()); ++L) {
            turn[static_cast<std::size_t>(L)] = adiabatic(L, law, temperature_K);
            if (L >= 2) {
                rate[static_cast<std::size_t>(L)] =
                    law.share * law.rate_per_cm_atm * std::pow(L * (L + 1.0), -law.lambda) *
                    std::exp(-law.beta * level_per_cm(L, lowerB, 0.0) / kT_per_cm);
            }
        }
        for (std::size_t from = 0; from < n; ++from) {
            for (std::size_t to = 0; to < n; ++to) {
                const int J = lines_[from].lower, K = lines_[to].lower, j = lines_[from].upper,
                          k = lines_[to].upper;
                if (K >= J) {
                    continue; // the way up follows from detailed balance
                }
                double sum = 0.0;
                for (int L = J - K; L <= J + K; L += 2) {
                    const auto l = static_cast<std::size_t>(L);
                    sum += wigner3j(J, K, L) * wigner3j(j, k, L) * wigner6j(J, j, 1, k, K, L) *
                           (2 * L + 1) * rate[l] / turn[l];
                }
                // With dipoles of one sign: the 3j symbols of the dipole carry it.
                const bool flips = (wigner3j(J, 1, j) < 0.0) != (wigner3j(K, 1, k) < 0.0);
                const double down = (flips ? -1.0 : 1.0) * (2 * K + 1) *
                                    std::sqrt((2.0 * j + 1.0) * (2.0 * k + 1.0)) *
                                    turn[static_cast<std::size_t>(J)] * sum;
                matrix_[to * n + from] += down;
                matrix_[from * n + to] += down * lines_[from].population / lines_[to].population;
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        matrix_[i * n + i] = lines_[i].width_per_cm;
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return lines_[a].intensity > lines_[b].intensity;
    });
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const std::size_t from = order[i];
        double stronger = 0.0, weaker = 0.0;
        for (std::size_t m = 0; m < n; ++m) {
            (m <= i ? stronger : weaker) += lines_[order[m]].dipole * matrix_[order[m] * n + from];
        }
        const double scale = weaker == 0.0 ? 1.0 : -stronger / weaker;
        scales_.push_back(scale);
        for (std::size_t m = i + 1; m < n; ++m) {
            const std::size_t to = order[m];
            matrix_[to * n + from] *= scale;
            matrix_[from * n + to] =
                matrix_[to * n + from] * lines_[from].population / lines_[to].population;
        }
    }
}

double LineMixing::leak() const {
    const std::size_t n = lines_.size();
    double largest = 0.0;
    for (std::size_t from = 0; from < n; ++from) {
        // The weakest lines have nobody left to give to.
        if (lines_[from].intensity < 1e-5 * 3e-18) {
            continue;
        }
        double sum = 0.0;
        for (std::size_t to = 0; to < n; ++to) {
            sum += lines_[to].dipole * matrix_[to * n + from];
        }
        largest =
            std::max(largest, std::abs(sum) / (lines_[from].dipole * lines_[from].width_per_cm));
    }
    return largest;
}

double LineMixing::mixed_cm2(double wavenumber_per_cm) const {
    // (nu - nu0 - i p W) x = population dipole, by elimination with pivots; then dipole x.
    const std::size_t n = lines_.size();
    std::vector<std::complex<double>> a(n * n), x(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i * n + j] = {0.0, -pressure_atm_ * matrix_[i * n + j]};
        }
        a[i * n + i] += wavenumber_per_cm - lines_[i].centre_per_cm;
        x[i] = lines_[i].population * lines_[i].dipole;
    }
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row) {
            if (std::abs(a[row * n + column]) > std::abs(a[pivot * n + column])) {
                pivot = row;
            }
        }
        if (pivot != column) {
            for (std::size_t j = 0; j < n; ++j) {
                std::swap(a[pivot * n + j], a[column * n + j]);
            }
            std::swap(x[pivot], x[column]);
        }
        for (std::size_t row = column + 1; row < n; ++row) {
            const std::complex<double> factor = a[row * n + column] / a[column * n + column];
            for (std::size_t j = column; j < n; ++j) {
                a[row * n + j] -= factor * a[column * n + j];
            }
            x[row] -= factor * x[column];
        }
    }
    double sum = 0.0;
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) {
            x[i] -= a[i * n + j] * x[j];
        }
        x[i] /= a[i * n + i];
        sum += lines_[i].dipole * x[i].imag();
    }
    return sum / std::numbers::pi;
}

double LineMixing::lorentz_cm2(double wavenumber_per_cm) const {
    double sum = 0.0;
    for (const Transition& line : lines_) {
        const double x = wavenumber_per_cm - line.centre_per_cm,
                     width = pressure_atm_ * line.width_per_cm;
        sum += line.intensity * width / (x * x + width * width);
    }
    return sum / std::numbers::pi;
}

double LineMixing::winged_cm2(double wavenumber_per_cm) const {
    double sum = 0.0;
    for (const Transition& line : lines_) {
        const double x = wavenumber_per_cm - line.centre_per_cm,
                     width = pressure_atm_ * line.width_per_cm;
        sum +=
            line.intensity * width / (x * x + width * width) * carbonDioxideChi(x, temperature_K_);
    }
    return sum / std::numbers::pi;
}

} // namespace irsg::lbl
