#include "irsg/signature/Fresnel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr std::size_t degree = 3;
/// Knots in (1 - c)^3; those between the ends, at 38.3 and 69.7 degrees, make the largest relative
/// difference smallest over dielectrics and metals.
constexpr double knot(double off) {
    return off * off * off;
}
constexpr std::array<double, FresnelShapes::count + degree + 1> knots{
    0.0, 0.0, 0.0, 0.0, knot(0.21477911), knot(0.6536634), 1.0, 1.0, 1.0, 1.0};

/// Angles that amounts follow from, evenly spaced; those beyond 80 degrees count less.
constexpr int places = 90;
constexpr double weightBeyond = 0.2;

} // namespace

double fresnelReflectivity(double n, double k, double cosine) {
    const std::complex<double> index(n, k);
    const std::complex<double> inside =
        std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index)); // cosine of refraction
    const std::complex<double> s = (cosine - index * inside) / (cosine + index * inside);
    const std::complex<double> p = (index * cosine - inside) / (index * cosine + inside);
    return 0.5 * (std::norm(s) + std::norm(p));
}

double normalReflectivity(double n, double k) {
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

double FresnelShapes::schlick(double cosine) {
    const double left = 1.0 - cosine, square = left * left;
    return square * square * left;
}

FresnelShapes::Values FresnelShapes::at(double cosine) {
    const double off = 1.0 - std::clamp(cosine, 0.0, 1.0), x = off * off * off;
    std::size_t interval = degree;
    while (interval + 1 < count && x >= knots[interval + 1])
        ++interval;
    // de Boor's recurrence: those that are not 0 there.
    std::array<double, degree + 1> some{1.0};
    for (std::size_t d = 1; d <= degree; ++d) {
        double left = 0.0;
        for (std::size_t i = 0; i < d; ++i) {
            const double above = knots[interval + 1 + i], below = knots[interval + 1 + i - d];
            const double part = some[i] / (above - below);
            some[i] = left + (above - x) * part;
            left = (x - below) * part;
        }
        some[d] = left;
    }
    Values all{};
    std::ranges::copy(some, all.begin() + static_cast<std::ptrdiff_t>(interval - degree));
    return all;
}

FresnelShapes::Values FresnelShapes::amountsOf(double n, double k) {
    static const std::vector<std::pair<double, Values>> shapes = [] {
        std::vector<std::pair<double, Values>> all;
        for (int i = 0; i < places; ++i) {
            const double cosine = std::cos(0.5 * pi * i / places);
            all.emplace_back(cosine, at(cosine));
        }
        return all;
    }();
    constexpr std::size_t inner = count - 2;
    std::array<std::array<double, inner + 1>, inner> equations{}; // and their right sides
    const double normal = normalReflectivity(n, k);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto& [cosine, shape] = shapes[i];
        const double reflectivity = fresnelReflectivity(n, k, cosine);
        const double weight = (9 * i <= 8 * shapes.size() ? 1.0 : weightBeyond) / reflectivity;
        const double left = reflectivity - normal * shape.front() - shape.back();
        for (std::size_t a = 0; a < inner; ++a) {
            const double own = weight * weight * shape[a + 1];
            for (std::size_t b = 0; b < inner; ++b)
                equations[a][b] += own * shape[b + 1];
            equations[a][inner] += own * left;
        }
    }
    // Elimination without pivots: the matrix is positive.
    for (std::size_t a = 0; a < inner; ++a)
        for (std::size_t b = a + 1; b < inner; ++b) {
            const double factor = equations[b][a] / equations[a][a];
            for (std::size_t c = a; c <= inner; ++c)
                equations[b][c] -= factor * equations[a][c];
        }
    Values all{};
    all.front() = normal;
    all.back() = 1.0;
    for (std::size_t a = inner; a-- > 0;) {
        double value = equations[a][inner];
        for (std::size_t b = a + 1; b < inner; ++b)
            value -= equations[a][b] * all[b + 1];
        all[a + 1] = value / equations[a][a];
    }
    for (double& value : all)
        value = std::clamp(value, 0.0, 1.0);
    return all;
}

const FresnelShapes::Values& FresnelShapes::means() {
    static const Values sums = [] {
        constexpr int steps = 4096;
        Values all{};
        for (int i = 0; i < steps; ++i) {
            const double cosine = (i + 0.5) / steps;
            const Values shape = at(cosine);
            for (std::size_t j = 0; j < count; ++j)
                all[j] += 2.0 * cosine * shape[j] / steps;
        }
        return all;
    }();
    return sums;
}

} // namespace irsg
