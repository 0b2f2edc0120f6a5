#include "irsg/radiance/AtmosphereSlices.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// Of the air's change over one slice: c^2 / 8 is then 5e-4.
constexpr double changeOfSlice = 0.0632;
constexpr int mostSlices = 64;
/// Air next to an object can be this many times as dense as the mean of the path to it.
constexpr double densest = 8.0;
/// Changes beyond are those of a body whose far side is black.
constexpr double largestChange = 20.0;
/// Light by which transmittances are weighed, beside grey light.
constexpr double ambientBody_K = 300.0;

/// In-band sums of the air at a range: by weight, transmitted light and path radiance.
struct InBand {
    double grey = 0.0, ambient = 0.0, path = 0.0;
};

/// Nodes that are summed together, first and behind the last.
using Nodes = std::pair<std::size_t, std::size_t>;

InBand sumsOf(const SpectralSampling& sampling, const Nodes& nodes,
              const std::vector<double>& ambient, const std::vector<double>& transmittance,
              const std::vector<double>& path) {
    InBand sums;
    const std::vector<double>& weights_um = sampling.weights_um();
    for (std::size_t i = nodes.first; i < nodes.second; ++i) {
        sums.grey += weights_um[i] * transmittance[i];
        sums.ambient += weights_um[i] * ambient[i] * transmittance[i];
        sums.path += weights_um[i] * path[i];
    }
    return sums;
}

/// |ln a / b|, at most `largestChange`.
double change(double a, double b) {
    if (!(a > 0.0) || !(b > 0.0))
        return a == b ? 0.0 : largestChange;
    return std::min(std::abs(std::log(a / b)), largestChange);
}

int slicesFor(double change) {
    return std::clamp(static_cast<int>(std::ceil(change / changeOfSlice)), 1, mostSlices);
}

/// At most what the air changes over a part of the path, if it is not more than `densest` times
/// denser there.
double mostChange(const SpectralSampling& sampling, const Nodes& nodes,
                  const std::vector<double>& ambient, const std::vector<double>& transmittance,
                  const std::vector<double>& path, double part) {
    const std::vector<double>& weights_um = sampling.weights_um();
    double grey = 0.0, warm = 0.0, greyDepth = 0.0, warmDepth = 0.0, fromPath = 0.0;
    for (std::size_t i = nodes.first; i < nodes.second; ++i) {
        const double t = transmittance[i];
        const double depth = t > 0.0 ? -t * std::log(t) : 0.0;
        grey += weights_um[i] * t;
        greyDepth += weights_um[i] * depth;
        warm += weights_um[i] * ambient[i] * t;
        warmDepth += weights_um[i] * ambient[i] * depth;
        fromPath += weights_um[i] * path[i];
    }
    const double arrives = warm + fromPath;
    if (!(grey > 0.0) || !(warm > 0.0))
        return largestChange;
    return densest * part *
           std::max({greyDepth / grey, warmDepth / warm, arrives > 0.0 ? fromPath / arrives : 0.0});
}

/// How dense the air at the target is in terms of the mean of the path, if it thins out as water
/// vapour does.
double densityAtTarget(const AtmosphericPath& path) {
    constexpr double scaleHeight_m = 2000.0;
    const double rise_m = path.sensorAltitude_m - path.targetAltitude_m;
    if (std::abs(rise_m) < 1.0)
        return 1.0;
    const double mean = scaleHeight_m * -std::expm1(-rise_m / scaleHeight_m) / rise_m;
    return std::clamp(1.0 / mean, 1.0 / densest, densest);
}

} // namespace

void planSlicesOf(AtmosphericQueryCache& air, std::vector<SampledBand>& bands, std::size_t number,
                  const RenderSettings& settings, ObjectGeometry& geometry) {
    geometry.slices_m.clear();
    geometry.atmosphereError = geometry.likelyAtmosphereError = 0.0;
    const double extent_m = geometry.farthest_m - geometry.nearest_m;
    if (!(extent_m > 0.0) || !(geometry.path.range_m > 0.0))
        return;

    double most = 0.0, estimate = 0.0;
    std::vector<double> changes; // by output of all bands: of the air over the extent, at most
    bool isKnown = true;         // some air holds the path to the reference point alone
    const SunPosition& sun = air.environment().sun;
    for (const SampledBand& band : bands) {
        const SpectralSampling& sampling = *band.sampling;
        const std::vector<double> ambient = sampling.planck(ambientBody_K);
        const auto pathAt = [&](double range_m) {
            return air
                .at(AtmosphericQuery::pathRadiance(atRange(geometry.path, range_m), sun),
                    band.sampling)
                .value;
        };
        const AtmosphereSamples& middle = band.air.objects[number].nodes.front();
        const SharedValues path = pathAt(geometry.path.range_m);
        std::vector<std::pair<Nodes, std::size_t>> changing; // where the air may do so too much
        for (const Nodes& nodes : band.outputs) {
            const double bound = mostChange(sampling, nodes, ambient, *middle.transmittance, *path,
                                            extent_m / geometry.path.range_m);
            estimate = std::max(estimate, bound);
            if (bound >= settings.atmosphereSliceFrom)
                changing.emplace_back(nodes, changes.size());
            changes.push_back(bound);
        }
        if (changing.empty())
            continue;
        const auto transmittanceAt = [&](double range_m) {
            return air
                .at(AtmosphericQuery::transmittance(atRange(geometry.path, range_m)), band.sampling)
                .value;
        };
        SharedValues passesNear, passesFar, pathNear, pathFar;
        try {
            passesNear = transmittanceAt(geometry.nearest_m);
            pathNear = pathAt(geometry.nearest_m);
            passesFar = transmittanceAt(geometry.farthest_m);
            pathFar = pathAt(geometry.farthest_m);
        } catch (const InputError&) {
            isKnown = false;
            continue;
        }
        for (const auto& [nodes, place] : changing) {
            const InBand near = sumsOf(sampling, nodes, ambient, *passesNear, *pathNear);
            const InBand far = sumsOf(sampling, nodes, ambient, *passesFar, *pathFar);
            const double arrives = 0.5 * (near.ambient + near.path + far.ambient + far.path);
            const double ofPath = arrives > 0.0 ? std::abs(far.path - near.path) / arrives : 0.0;
            changes[place] =
                std::max({change(near.grey, far.grey), change(near.ambient, far.ambient), ofPath});
            most = std::max(most, changes[place]);
        }
    }
    const double likely = 0.5 * estimate / densest * densityAtTarget(geometry.path);
    if (estimate < settings.atmosphereSliceFrom) {
        geometry.atmosphereError = 0.5 * estimate;
        geometry.likelyAtmosphereError = std::min(likely, geometry.atmosphereError);
        return;
    }
    if (!isKnown) {
        geometry.atmosphereError = 0.5 * std::min(estimate, largestChange);
        geometry.likelyAtmosphereError = std::min(likely, geometry.atmosphereError);
        return;
    }
    if (most < settings.atmosphereSliceFrom) {
        geometry.atmosphereError = geometry.likelyAtmosphereError = 0.5 * most;
        return;
    }
    const int slices = slicesFor(most);
    for (int i = 0; i <= slices; ++i)
        geometry.slices_m.push_back(geometry.nearest_m + extent_m * i / slices);
    double ofOne = 0.0; // change between two nodes that are taken
    auto of = changes.begin();
    for (SampledBand& band : bands)
        for (std::size_t k = 0; k < band.outputs.size(); ++k, ++of) {
            const int step = std::max(1, slices / slicesFor(*of));
            band.sliceSteps[number].push_back(step);
            ofOne = std::max(ofOne, *of * step / slices);
        }
    geometry.atmosphereError = geometry.likelyAtmosphereError = ofOne * ofOne / 8.0;
}

} // namespace irsg
