#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/atmosphere/ck/CkTraining.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Quadrature.h"

namespace irsg {

namespace {

constexpr double opaque = 1e-3; ///< as in the training

/// What a surface sends at the nodes of a sampling.
using Source = std::function<std::vector<double>(const SpectralSampling&)>;

std::vector<double> product(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] *= b[i];
    return a;
}

std::vector<Source> sourcesOf(const CkRequest& request) {
    std::vector<Source> all;
    for (const double temperature_K : {220.0, 260.0, 300.0, 450.0, 900.0, 2200.0})
        all.emplace_back(
            [=](const SpectralSampling& sampling) { return sampling.planck(temperature_K); });
    const SpectralRange& range = request.band.range();
    const auto ofSpectrum = [](const Spectrum& spectrum, bool emits) -> Source {
        return [spectrum, emits](const SpectralSampling& sampling) {
            std::vector<double> values = sampling.sampled(spectrum);
            for (double& value : values)
                value = std::max(value, 0.0);
            return emits ? product(std::move(values), sampling.planck(400.0)) : values;
        };
    };
    for (const double slope : {1.0, -1.0})
        all.push_back(ofSpectrum(
            Spectrum({range.min_um, range.max_um}, {0.5 - 0.5 * slope, 0.5 + 0.5 * slope}), true));
    for (const Spectrum* material : request.materials)
        if (!material->isConstant())
            all.push_back(ofSpectrum(*material, true));
    for (const Spectrum* radiance : request.radiances)
        if (!radiance->isConstant())
            all.push_back(ofSpectrum(*radiance, false));
    return all;
}

/// Relative errors of in-band quantities, those that are next to nothing in terms of `least`.
class Differences {
  public:
    void add(double expected, double found, double least) {
        const double scale = std::max(expected, least);
        if (!(scale > 1e-30))
            return;
        const double error = std::abs(found - expected) / scale;
        largest_ = std::max(largest_, error);
        squares_ += error * error;
        ++count_;
    }
    CkErrors result() const {
        return {largest_, count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0.0};
    }

  private:
    double largest_ = 0.0, squares_ = 0.0;
    std::size_t count_ = 0;
};

/// An answer at quadrature points and in the spectral mode.
struct BothWays {
    std::vector<double> points;
    Spectrum spectrum;
};

} // namespace

CkErrors heldOutErrors(const Atmosphere& air, const SensorCkData& points, const CkRequest& request,
                       const std::vector<AtmosphericPath>& paths) {
    const SpectralRange& range = request.band.range();
    const auto ask = [&](const AtmosphericQuery& query) -> std::optional<BothWays> {
        if (!air.supports(query.quantity))
            return std::nullopt;
        try {
            return BothWays{air.provide(query, points), air.spectrum(query, range)};
        } catch (const InputError&) { // its tables do not reach there
            return std::nullopt;
        }
    };
    const std::vector<Source> sources = sourcesOf(request);
    const double ambient_K =
        air.supports(AtmosphereProperty::ambientTemperature)
            ? air.ambientTemperature_K(paths.empty() ? 0.0 : paths.front().targetAltitude_m)
            : 288.15;
    const double ambient = points.integrate(points.planck(ambient_K));
    Differences differences;
    for (const AtmosphericPath& path : paths) {
        const auto transmittance = ask(AtmosphericQuery::transmittance(path));
        if (!transmittance)
            continue;
        AtmosphericPath across = path;
        across.azimuth_rad = request.sun.azimuth_rad + 0.5 * std::numbers::pi;
        const auto radiance = ask(AtmosphericQuery::pathRadiance(across, request.sun));
        std::vector<BothWays> lights;
        for (const AtmosphericQuery& query :
             {AtmosphericQuery::solarIrradiance(path.targetAltitude_m, request.sun),
              AtmosphericQuery::downwardFlux(path.targetAltitude_m, request.sun),
              AtmosphericQuery::upwardFlux(path.targetAltitude_m, request.sun)})
            if (auto light = ask(query))
                lights.push_back(std::move(*light));

        std::vector<const Spectrum*> axes = {&transmittance->spectrum};
        if (radiance)
            axes.push_back(&radiance->spectrum);
        for (const BothWays& light : lights)
            axes.push_back(&light.spectrum);
        for (const auto* kind : {&request.materials, &request.radiances})
            axes.insert(axes.end(), kind->begin(), kind->end());
        const SpectralQuadrature quadrature(request.band, axes);
        const std::vector<double> tau = quadrature.sampled(transmittance->spectrum);
        const auto compare = [&](const std::vector<double>& source,
                                 const std::vector<double>& ofPoints) {
            differences.add(quadrature.integrate(source, tau),
                            points.integrate(ofPoints, transmittance->points),
                            opaque * points.integrate(ofPoints));
        };
        for (const Source& source : sources)
            compare(source(quadrature), source(points));
        for (const BothWays& light : lights)
            compare(quadrature.sampled(light.spectrum), light.points);
        if (radiance)
            differences.add(quadrature.integrate(quadrature.sampled(radiance->spectrum)),
                            points.integrate(radiance->points), opaque * ambient);
    }
    return differences.result();
}

} // namespace irsg
