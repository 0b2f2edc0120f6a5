#include "irsg/signature/Fresnel.h"

#include <cmath>
#include <complex>

namespace irsg {

namespace {

/// Places of the midpoint rule, and the integral of q squared: B(3, 13).
constexpr int places = 64;
constexpr double dipSquared = 1.0 / 1365.0;

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

double FresnelShapes::dip(double cosine) {
    return cosine * (1.0 - cosine) * schlick(cosine);
}

double FresnelShapes::part(std::size_t k, double cosine, bool hasDip) {
    const double p = schlick(cosine);
    if (k == 1)
        return p;
    const double q = hasDip ? dip(cosine) : 0.0;
    return k == 0 ? 1.0 - p - raisedDip * q : q;
}

double FresnelShapes::dipOf(double n, double k) {
    const double normal = normalReflectivity(n, k);
    double sum = 0.0;
    for (int i = 0; i < places; ++i) {
        const double cosine = (i + 0.5) / places;
        const double off = fresnelReflectivity(n, k, cosine) - normal -
                           (1.0 - normal) * FresnelShapes::schlick(cosine);
        sum += off * dip(cosine) / places;
    }
    return sum / dipSquared;
}

} // namespace irsg
