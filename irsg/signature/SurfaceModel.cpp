#include "irsg/signature/SurfaceModel.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Facets that stand for all; one for surfaces that are smoother than that.
constexpr int samplesOfLobe = 24;
constexpr double smooth = 0.02;

} // namespace

SurfaceModel::SurfaceModel(Microfacets facets, std::size_t lobes, std::size_t components,
                           std::vector<double> key)
    : facets_(facets), lobes_(lobes), components_(components), key_(std::move(key)) {
    samples_.resize(roughness() < smooth ? 1 : samplesOfLobe);
    for (std::size_t i = 0; i < samples_.size(); ++i)
        samples_[i] = facet(i, 0.5, 0.0);
}

SurfaceDirection SurfaceModel::facet(std::size_t number, double share, double turn) const {
    const double golden = pi * (3.0 - std::sqrt(5.0));
    const auto count = static_cast<double>(samples_.size()), i = static_cast<double>(number);
    const double cosine = samples_.size() == 1 ? 1.0 : facets_.cosineOfShare((i + share) / count);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double azimuth = golden * i + 2.0 * pi * turn;
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

void SurfaceModel::setAlbedos(std::size_t k, std::vector<double> albedos) {
    albedos_[k] = std::move(albedos);
    meanAlbedos_[k] = 0.0;
    // Of what is linear in the root between nodes, times twice the cosine.
    for (std::size_t node = 0; node < albedoIntervals; ++node) {
        const double low = static_cast<double>(node) / albedoIntervals,
                     high = low + 1.0 / albedoIntervals;
        const double slope = (albedos_[k][node + 1] - albedos_[k][node]) * albedoIntervals;
        const double atZero = albedos_[k][node] - slope * low;
        meanAlbedos_[k] += atZero * (std::pow(high, 4) - std::pow(low, 4)) +
                           0.8 * slope * (std::pow(high, 5) - std::pow(low, 5));
    }
}

void SurfaceModel::setExcess(std::vector<double> factors) {
    excess_ = std::move(factors);
}

double SurfaceModel::at(const std::vector<double>& values, double cosine) {
    const double place = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * albedoIntervals;
    const auto node = std::min(static_cast<std::size_t>(place), albedoIntervals - 1);
    const double part = place - static_cast<double>(node);
    return (1.0 - part) * values[node] + part * values[node + 1];
}

double SurfaceModel::albedo(std::size_t k, double cosine) const {
    return at(albedos_[k], cosine);
}

double SurfaceModel::sent(std::size_t k, double cosine) const {
    const bool hasExcess = hasLobe(k) && !excess_.empty();
    return albedo(k, cosine) * (hasExcess ? at(excess_, cosine) : 1.0);
}

double SurfaceModel::reflected(const Amounts& amounts, double cosine) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < components_; ++k)
        sum += amounts[k] * sent(k, cosine);
    return sum;
}

double SurfaceModel::facetWeight(std::size_t k, const SurfaceDirection& to,
                                 const SurfaceDirection& facet) const {
    const double cosine = dot(to, facet);
    const SurfaceDirection from = mirrored(to, facet);
    if (!(cosine > 0.0) || !(from.z > 0.0) || !(to.z > 0.0))
        return 0.0;
    return brdf_per_sr(k, to, from) * from.z * 4.0 * cosine / facetDensity_per_sr(facet);
}

SurfaceModel::Amounts SurfaceModel::facetWeights(const SurfaceDirection& to,
                                                 const SurfaceDirection& facet) const {
    Amounts all{};
    for (std::size_t k = 0; k < lobes_; ++k)
        all[k] = facetWeight(k, to, facet);
    return all;
}

SurfaceModel::Amounts SurfaceModel::scaledReflection(const Amounts& amounts, double limit,
                                                     double scale) const {
    double reflected = 0.0;
    for (std::size_t k = 0; k < components_; ++k)
        reflected += amounts[k] * meanAlbedos_[k];
    Amounts all = amounts;
    if (scale == 1.0 || !(reflected > 0.0))
        return all;
    const double factor = std::max(limit - scale * (limit - reflected), 0.0) / reflected;
    for (double& amount : all)
        amount *= factor;
    return all;
}

SurfaceModel::Amounts SurfaceModel::amountsAt(const Material& material,
                                              double wavelength_um) const {
    std::vector<double> values;
    for (const Spectrum* spectrum : inputs(material))
        values.push_back(spectrum->at(wavelength_um));
    return amounts(values, 1.0);
}

} // namespace irsg
