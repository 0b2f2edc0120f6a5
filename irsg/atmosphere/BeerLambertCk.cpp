#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/ck/CkCache.h"
#include "irsg/atmosphere/ck/CkTraining.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

std::vector<AtmosphericPath> homogeneousPaths(const std::vector<double>& ranges_m) {
    std::vector<AtmosphericPath> paths;
    for (const double range_m : ranges_m) // altitudes mean nothing in this air
        paths.push_back({1000.0, 1000.0, range_m});
    return paths;
}

CacheKey keyOf(const BeerLambertParameters& air, const CkRequest& request) {
    CacheKey key;
    key.add(ckTraining).add("Beer-Lambert");
    key.add(air.airTemperature_K).add(air.groundTemperature_K);
    for (const Spectrum* spectrum :
         {&air.extinction_per_m, &air.solarIrradiance_W_m2_um, &air.downwardFlux_W_m2_um,
          &air.upwardFlux_W_m2_um,
          air.skyRadiance_W_m2_sr_um ? &*air.skyRadiance_W_m2_sr_um : nullptr}) {
        key.add(spectrum != nullptr ? 1.0 : 0.0);
        if (spectrum != nullptr)
            addTo(key, *spectrum);
    }
    addTo(key, request);
    return key;
}

} // namespace

std::vector<double> BeerLambert::candidates(const SpectralRange& range) const {
    constexpr double widths = 400.0;      // of the band: Planck's function and responses
    constexpr double growth = 1.1;        // of the extinction: its exponential
    constexpr double least_per_m = 1e-8;  // that any path notices
    constexpr std::size_t mostSteps = 64; // between two nodes of the extinction
    const std::vector<double> kinks = this->kinks(range);
    std::vector<double> wavelengths_um = {kinks.front()};
    for (std::size_t i = 0; i + 1 < kinks.size(); ++i) {
        const double step_um = kinks[i + 1] - kinks[i];
        const double a = std::max(parameters_.extinction_per_m.at(kinks[i]), least_per_m);
        const double b = std::max(parameters_.extinction_per_m.at(kinks[i + 1]), least_per_m);
        const double bends = std::abs(std::log(b / a)) / std::log(growth);
        const auto even = static_cast<std::size_t>(std::ceil(step_um * widths / range.width_um()));
        const auto steep = std::min(static_cast<std::size_t>(std::ceil(bends)), mostSteps);
        // Steps of equal growth, of which each is cut evenly.
        const std::size_t outer = std::max<std::size_t>(steep, 1);
        const std::size_t inner = std::max<std::size_t>((even + outer - 1) / outer, 1);
        double from_um = kinks[i];
        for (std::size_t k = 1; k <= outer; ++k) {
            const double part = static_cast<double>(k) / static_cast<double>(outer);
            const double grown =
                std::abs(b - a) > 1e-6 * a ? (lerpByRatio(a, b, part) - a) / (b - a) : part;
            const double to_um = k == outer ? kinks[i + 1] : kinks[i] + grown * step_um;
            for (std::size_t n = 1; n <= inner; ++n)
                wavelengths_um.push_back(n == inner ? to_um
                                                    : from_um + (to_um - from_um) *
                                                                    static_cast<double>(n) /
                                                                    static_cast<double>(inner));
            from_um = to_um;
        }
    }
    const auto rest = std::ranges::unique(wavelengths_um);
    wavelengths_um.erase(rest.begin(), rest.end());
    return wavelengths_um;
}

std::vector<double> BeerLambert::valuesAt(const AtmosphericQuery& query,
                                          const std::vector<double>& wavelengths_um) const {
    const auto curve = [&](auto valueAt) {
        std::vector<double> values;
        values.reserve(wavelengths_um.size());
        for (const double wavelength_um : wavelengths_um)
            values.push_back(
                valueAt(wavelength_um, parameters_.extinction_per_m.at(wavelength_um)));
        return values;
    };
    const auto air = [this](double wavelength_um) {
        return planckRadiance_W_m2_sr_um(wavelength_um, parameters_.airTemperature_K);
    };
    const double range_m = query.path.range_m;
    switch (query.quantity) {
    case AtmosphereProperty::transmittance:
        return curve([&](double, double extinction) { return std::exp(-extinction * range_m); });
    case AtmosphereProperty::pathRadiance:
        return curve([&](double at_um, double extinction) {
            return -std::expm1(-extinction * range_m) * air(at_um);
        });
    case AtmosphereProperty::backgroundRadiance: {
        const auto& [altitude_m, elevation_rad, azimuth_rad] = query.sight;
        const auto& sky = parameters_.skyRadiance_W_m2_sr_um;
        if (elevation_rad >= 0.0)
            return curve([&](double at_um, double extinction) {
                return extinction > 0.0 ? air(at_um) : sky ? sky->at(at_um) : 0.0;
            });
        const double way_m = altitude_m / std::sin(-elevation_rad);
        return curve([&](double at_um, double extinction) {
            const double depth = way_m > 0.0 ? extinction * way_m : 0.0;
            return std::exp(-depth) *
                       planckRadiance_W_m2_sr_um(at_um, parameters_.groundTemperature_K) -
                   std::expm1(-depth) * air(at_um);
        });
    }
    case AtmosphereProperty::solarIrradiance: {
        const double part = sunView(query.altitude_m, query.sun).part;
        return curve([&](double at_um, double) {
            return part * parameters_.solarIrradiance_W_m2_um.at(at_um);
        });
    }
    case AtmosphereProperty::upwardFlux:
        return curve(
            [&](double at_um, double) { return parameters_.upwardFlux_W_m2_um.at(at_um); });
    case AtmosphereProperty::downwardFlux:
        return curve(
            [&](double at_um, double) { return parameters_.downwardFlux_W_m2_um.at(at_um); });
    default:
        return std::vector<double>(wavelengths_um.size(), 0.0); // nothing scatters
    }
}

std::vector<double> BeerLambert::valuesAtPoints(const AtmosphericQuery& query,
                                                const SensorCkData& points) const {
    return valuesAt(query, points.wavelengths_um());
}

std::shared_ptr<const SensorCkData> BeerLambert::prepareCk(const CkRequest& request) const {
    checkRange(request.band.range());
    const std::vector<double> wavelengths_um = candidates(request.band.range());
    CkAtmosphere known{.nodes = CkNodes(wavelengths_um, 0, request.band),
                       .values = {},
                       .ambient_K = parameters_.airTemperature_K,
                       .paths = homogeneousPaths({10.0, 30.0, 100.0, 300.0, 1e3, 2e3, 3.5e3, 6e3,
                                                  9e3, 13e3, 20e3, 30e3, 50e3, 80e3, 150e3}),
                       .sights = {},
                       .heldOut =
                           homogeneousPaths({11.0, 70.0, 800.0, 2.7e3, 7.5e3, 16e3, 38e3, 100e3})};
    for (const double altitude_m : {2.0, 100.0, 1000.0, 10000.0})
        for (const double elevation_rad : {-1.5, -0.3, -0.05, 0.1})
            known.sights.push_back({altitude_m, elevation_rad, 0.0});
    std::vector<double> falling; // as the nodes are
    for (std::size_t i = 0; i < known.nodes.size(); ++i)
        falling.push_back(known.nodes.wavelength_um(i));
    known.values = [&](const AtmosphericQuery& query) { return valuesAt(query, falling); };
    return cachedOrTrained(ckStore(), keyOf(parameters_, request), known.nodes, request.band,
                           [&] { return SensorCkData::prepare(known, *this, request); });
}

} // namespace irsg
