#include "irsg/radiometry/Quadrature.h"

#include <algorithm>
#include <functional>
#include <string>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/PlanckPanels.h"

namespace irsg {

SpectralQuadrature::SpectralQuadrature(const Band& band,
                                       std::span<const Spectrum* const> breakpoints,
                                       double coldest_K) {
    std::vector<const Spectrum*> kinked(breakpoints.begin(), breakpoints.end());
    kinked.push_back(&band.response());
    const std::vector<double> edges = mergeAxes(kinked, band.range());

    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        std::vector<PlanckPanel> pieces = planckPanels({edges[i], edges[i + 1]}, coldest_K);
        std::ranges::reverse(pieces);
        for (const PlanckPanel& piece : pieces) {
            const GaussRule& rule = gaussLegendre(piece.points);
            for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                wavelengths_um_.push_back(piece.range.min_um +
                                          piece.range.width_um() * rule.nodes[k]);
                weights_um_.push_back(piece.range.width_um() * rule.weights[k]);
            }
        }
    }
    const std::vector<double> responses = band.response().sample(wavelengths_um_);
    std::ranges::transform(weights_um_, responses, weights_um_.begin(), std::multiplies<>());
}

std::vector<double> SpectralQuadrature::sample(const Spectrum& spectrum) const {
    return spectrum.sample(wavelengths_um_);
}

std::vector<double> SpectralQuadrature::planck(double temperature_K) const {
    std::vector<double> radiances;
    radiances.reserve(size());
    for (const double wavelength_um : wavelengths_um_) {
        radiances.push_back(planckRadiance_W_m2_sr_um(wavelength_um, temperature_K));
    }
    return radiances;
}

double SpectralQuadrature::integrate(std::span<const double> values) const {
    if (values.size() != size()) {
        throw LogicError("a quadrature of " + std::to_string(size()) + " nodes was given " +
                         std::to_string(values.size()) + " values");
    }
    double integral = 0.0;
    for (std::size_t i = 0; i < size(); ++i) {
        integral += weights_um_[i] * values[i];
    }
    return integral;
}

double SpectralQuadrature::integrate(std::span<const double> a, std::span<const double> b) const {
    if (a.size() != size() || b.size() != size()) {
        throw LogicError("a quadrature of " + std::to_string(size()) + " nodes was given " +
                         std::to_string(a.size()) + " and " + std::to_string(b.size()) + " values");
    }
    double integral = 0.0;
    for (std::size_t i = 0; i < size(); ++i) {
        integral += weights_um_[i] * a[i] * b[i];
    }
    return integral;
}

} // namespace irsg
