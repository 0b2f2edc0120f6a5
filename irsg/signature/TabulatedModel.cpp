#include "irsg/signature/TabulatedModel.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Places of sums over a table, of reflection and azimuth.
constexpr int reflections = 180, azimuths = 72;
/// What facets that stand for a table are at the least and at the most.
constexpr double narrowest = 0.02;

double cosineOfPlace(int place) {
    // Even in the angle: tables are.
    return std::cos(0.5 * pi * (place + 0.5) / reflections);
}

/// Reflectance of light at an angle: the integral of the BRDF.
double reflectanceOf(const ReflectanceTable& table, std::size_t w, double incidence_deg) {
    if (!table.isBrdf())
        return table.at(w, incidence_deg);
    double sum = 0.0;
    for (int place = 0; place < reflections; ++place) {
        const double angle_deg = 90.0 * (place + 0.5) / reflections;
        const double cosine = cosineOfPlace(place);
        double ofRing = 0.0;
        for (int around = 0; around < azimuths; ++around)
            ofRing += table.at(w, incidence_deg, angle_deg, 180.0 * (around + 0.5) / azimuths);
        sum += ofRing * cosine * std::sqrt(1.0 - cosine * cosine);
    }
    return sum * (0.5 * pi / reflections) * (2.0 * pi / azimuths);
}

/// How wide facets are that would reflect so: the mean square slope of those half way, for light
/// from 20 deg.
double widthOf(const ReflectanceTable& table) {
    if (!table.isBrdf())
        return 1.0;
    const double incidence_deg = 20.0;
    const SurfaceDirection from{std::sin(radians(incidence_deg)), 0.0,
                                std::cos(radians(incidence_deg))};
    double sum = 0.0, squares = 0.0;
    for (int place = 0; place < reflections; ++place)
        for (int around = 0; around < azimuths; ++around) {
            const double azimuth = pi * (around + 0.5) / azimuths, cosine = cosineOfPlace(place);
            const double sine = std::sqrt(1.0 - cosine * cosine);
            const SurfaceDirection to{sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
            const double weight =
                table.at(0, incidence_deg, 90.0 * (place + 0.5) / reflections, degrees(azimuth)) *
                sine * cosine;
            const SurfaceDirection facet = halfway(to, from);
            sum += weight;
            squares += weight * (1.0 / (facet.z * facet.z) - 1.0);
        }
    return sum > 0.0 ? std::clamp(std::sqrt(squares / sum), narrowest, 1.0) : 1.0;
}

} // namespace

std::vector<double> TabulatedModel::keyOf(const Material& material) {
    if (material.reflectanceTable.empty())
        throw InputError(
            Diagnostic{material.name, "reflectanceTable", "nothing", "a table of reflectance"});
    std::vector<double> key = material.reflectanceTable.key();
    key.insert(key.begin(), 5.0);
    return key;
}

TabulatedModel::TabulatedModel(const Material& material)
    : SurfaceModel(Microfacets(FacetDistribution::ggx, widthOf(material.reflectanceTable)),
                   material.reflectanceTable.isBrdf()
                       ? material.reflectanceTable.wavelengths_um().size()
                       : 0,
                   material.reflectanceTable.wavelengths_um().size(), keyOf(material)),
      table_(material.reflectanceTable) {
    std::vector<double> excess(albedoIntervals + 1, 1.0);
    for (std::size_t k = 0; k < components(); ++k) {
        std::vector<double> albedos;
        for (std::size_t node = 0; node <= albedoIntervals; ++node) {
            const double root = static_cast<double>(node) / albedoIntervals;
            const double reflectance = reflectanceOf(table_, k, degrees(std::acos(root * root)));
            albedos.push_back(std::min(reflectance, 1.0));
            excess[node] = std::max(excess[node], reflectance);
        }
        setAlbedos(k, std::move(albedos));
    }
    setExcess(std::move(excess));
}

double TabulatedModel::brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                                   const SurfaceDirection& from,
                                   const SlopeSpread& /*spread*/) const {
    if (!(to.z > 0.0) || !(from.z > 0.0))
        return 0.0;
    if (!table_.isBrdf()) {
        const double mean = meanAlbedo(k);
        return mean > 0.0 ? albedo(k, to.z) * albedo(k, from.z) / (pi * mean) : 0.0;
    }
    const double across = std::hypot(to.x, to.y) * std::hypot(from.x, from.y);
    const double cosine = across > 1e-12 ? (to.x * from.x + to.y * from.y) / across : -1.0;
    return table_.at(k, degrees(std::acos(std::min(from.z, 1.0))),
                     degrees(std::acos(std::min(to.z, 1.0))),
                     degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
}

std::vector<const Spectrum*> TabulatedModel::inputs(const Material& material) const {
    std::vector<const Spectrum*> all = {&material.transmissivity};
    for (const Spectrum& share : material.reflectanceTable.shares())
        all.push_back(&share);
    return all;
}

SurfaceModel::Amounts TabulatedModel::amounts(std::span<const double> inputs, double scale) const {
    Amounts all{};
    for (std::size_t k = 0; k < components(); ++k)
        all[k] = inputs[k + 1];
    return scaledReflection(all, 1.0 - inputs[0], scale);
}

} // namespace irsg
