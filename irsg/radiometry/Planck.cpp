#include "irsg/radiometry/Planck.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/PlanckPanels.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {

namespace {

constexpr double smallestRadiance = 1e-290;
constexpr double coldestSought_K = 1.0;
constexpr double hottestSought_K = 1e6;

/// Up to here the exponential is taken as vectors take it.
constexpr double largestVectorExponent = 500.0;

double exponentOf(double wavelength_um, double temperature_K) {
    return secondRadiationConstant_um_K / (wavelength_um * temperature_K);
}

/// 2 h c^2 / lambda^5.
double prefactorOf(double wavelength_um) {
    const double square = wavelength_um * wavelength_um;
    return firstRadiationConstant_W_um4_m2_sr / (square * square * wavelength_um);
}

/// Planck's law for positive arguments and exponents up to the largest of vectors, without
/// branches.
inline double moderateRadiance(double wavelength_um, double perTemperature_um) {
    const double square = wavelength_um * wavelength_um;
    return firstRadiationConstant_W_um4_m2_sr /
           (square * square * wavelength_um * vectorExpm1(perTemperature_um / wavelength_um));
}

IRSG_VECTOR_CLONES void moderateRadiances(const double* wavelength_um, double perTemperature_um,
                                          std::size_t n, double* radiance) {
    for (std::size_t i = 0; i < n; ++i)
        radiance[i] = moderateRadiance(wavelength_um[i], perTemperature_um);
}

/// The integral of L_bb R over the band, and of its derivative with respect to temperature.
struct BandIntegral {
    double radiance = 0.0;
    double derivative = 0.0;
};

BandIntegral integrateBand(const Band& band, double temperature_K) {
    const Spectrum* const response[] = {&band.response()};
    const std::vector<double> axis = mergeAxes(response, band.range());
    const double largestResponse = band.response().maximum();

    // From the longest wavelength down. Below the peak of the Planck function everything that is
    // still to come is less than the radiance here times the width left: once that is lost in the
    // rounding of the sum, the rest is.
    BandIntegral result;
    std::vector<double> points;
    for (std::size_t i = axis.size() - 1; i > 0; --i) {
        for (const PlanckPanel& panel : planckPanels({axis[i - 1], axis[i]}, temperature_K)) {
            const double upper_um = panel.range.max_um;
            const double rest = planckRadiance_W_m2_sr_um(upper_um, temperature_K) *
                                largestResponse * (upper_um - band.range().min_um);
            if (exponentOf(upper_um, temperature_K) > 6.0 && rest <= 1e-15 * result.radiance)
                return result;
            const GaussRule& rule = gaussLegendre(panel.points);
            points.clear();
            for (const double node : rule.nodes)
                points.push_back(panel.range.min_um + panel.range.width_um() * node);
            const std::vector<double> responses = band.response().sample(points);
            for (std::size_t k = 0; k < points.size(); ++k) {
                const double weight = rule.weights[k] * panel.range.width_um() * responses[k];
                const double radiance = planckRadiance_W_m2_sr_um(points[k], temperature_K);
                const double x = exponentOf(points[k], temperature_K);
                result.radiance += weight * radiance;
                result.derivative += weight * radiance * x / (-temperature_K * std::expm1(-x));
            }
        }
    }
    return result;
}

} // namespace

double planckRadiance_W_m2_sr_um(double wavelength_um, double temperature_K) {
    if (!(wavelength_um > 0.0 && temperature_K > 0.0))
        return 0.0;
    const double perTemperature_um = secondRadiationConstant_um_K / temperature_K;
    const double x = perTemperature_um / wavelength_um;
    // exp(x) comes close to the end of the numbers: it is divided by in two halves.
    const double radiance =
        x <= largestVectorExponent
            ? moderateRadiance(wavelength_um, perTemperature_um)
            : prefactorOf(wavelength_um) * std::exp(-0.5 * x) * std::exp(-0.5 * x);
    return radiance > smallestRadiance ? radiance : 0.0;
}

void planckRadiances_W_m2_sr_um(std::span<const double> wavelengths_um, double temperature_K,
                                std::span<double> radiances_W_m2_sr_um) {
    if (wavelengths_um.size() != radiances_W_m2_sr_um.size())
        throw LogicError("black bodies at " + std::to_string(wavelengths_um.size()) +
                         " wavelengths for " + std::to_string(radiances_W_m2_sr_um.size()) +
                         " radiances");
    const double perTemperature_um = secondRadiationConstant_um_K / temperature_K;
    moderateRadiances(wavelengths_um.data(), perTemperature_um, wavelengths_um.size(),
                      radiances_W_m2_sr_um.data());
    // The ends of the numbers, one by one.
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i)
        if (!(perTemperature_um <= largestVectorExponent * wavelengths_um[i] &&
              radiances_W_m2_sr_um[i] > smallestRadiance))
            radiances_W_m2_sr_um[i] = planckRadiance_W_m2_sr_um(wavelengths_um[i], temperature_K);
}

double planckDerivative_W_m2_sr_um_K(double wavelength_um, double temperature_K) {
    // dL/dT = L (x / T) exp(x) / (exp(x) - 1) with x = h c / lambda k T.
    const double radiance = planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
    if (radiance == 0.0)
        return 0.0;
    // Where x vanishes the radiance is that of Rayleigh and Jeans, 2 c k T / lambda^4.
    const double x = exponentOf(wavelength_um, temperature_K);
    return x > 0.0 ? radiance * x / (-temperature_K * std::expm1(-x))
                   : prefactorOf(wavelength_um) * wavelength_um / secondRadiationConstant_um_K;
}

std::optional<double> brightnessTemperature_K(double wavelength_um, double radiance_W_m2_sr_um) {
    if (!(wavelength_um > 0.0 && std::isfinite(wavelength_um) && radiance_W_m2_sr_um > 0.0 &&
          std::isfinite(radiance_W_m2_sr_um))) {
        return std::nullopt;
    }
    // T = c2 / (lambda ln(1 + 2 h c^2 / lambda^5 L)); the ratio of a tiny radiance overflows, its
    // logarithm does not.
    const double prefactor = prefactorOf(wavelength_um);
    const double ratio = prefactor / radiance_W_m2_sr_um;
    const double exponent = std::isfinite(ratio)
                                ? std::log1p(ratio)
                                : std::log(prefactor) - std::log(radiance_W_m2_sr_um);
    const double temperature_K = secondRadiationConstant_um_K / (wavelength_um * exponent);
    if (!(temperature_K > 0.0 && std::isfinite(temperature_K)))
        return std::nullopt;
    return temperature_K;
}

double bandRadiance_W_m2_sr(const Band& band, double temperature_K) {
    if (!(temperature_K > 0.0))
        return 0.0;
    return integrateBand(band, temperature_K).radiance;
}

std::optional<double> apparentTemperature_K(const Band& band, double radiance_W_m2_sr) {
    if (!(radiance_W_m2_sr > 0.0 && std::isfinite(radiance_W_m2_sr)) ||
        radiance_W_m2_sr < bandRadiance_W_m2_sr(band, coldestSought_K) ||
        radiance_W_m2_sr > bandRadiance_W_m2_sr(band, hottestSought_K)) {
        return std::nullopt;
    }

    // ln L is nearly a straight line over u = 1/T, so Newton's method in u takes a few steps; it is
    // kept inside a bracket that shrinks with every step, and halves it where it would leave.
    double hot_1_K = 1.0 / hottestSought_K;
    double cold_1_K = 1.0 / coldestSought_K;
    const double start_K =
        brightnessTemperature_K(band.range().centre_um(), radiance_W_m2_sr / band.area_um())
            .value_or(300.0);
    double u_1_K = std::clamp(1.0 / start_K, hot_1_K, cold_1_K);
    const double sought = std::log(radiance_W_m2_sr);
    double misfit = 1.0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const BandIntegral integral = integrateBand(band, 1.0 / u_1_K);
        double next_1_K = std::sqrt(hot_1_K * cold_1_K);
        if (integral.radiance > 0.0) {
            misfit = std::log(integral.radiance) - sought;
            (misfit > 0.0 ? hot_1_K : cold_1_K) = u_1_K;
            const double slope = -integral.derivative / (integral.radiance * u_1_K * u_1_K);
            const double newton_1_K = u_1_K - misfit / slope;
            if (newton_1_K >= hot_1_K && newton_1_K <= cold_1_K)
                next_1_K = newton_1_K;
        } else {
            misfit = -1.0;
            cold_1_K = u_1_K;
            next_1_K = std::sqrt(hot_1_K * cold_1_K);
        }
        const double step = std::abs(next_1_K - u_1_K);
        u_1_K = next_1_K;
        if (step <= 1e-13 * u_1_K)
            break;
    }

    // A radiance below the smallest that is told from zero has no black body of its own.
    if (std::abs(misfit) > 1e-6)
        return std::nullopt;
    return 1.0 / u_1_K;
}

} // namespace irsg
