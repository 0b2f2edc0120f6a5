#include <algorithm>
#include <cmath>
#include <map>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Errors.h"

namespace irsg::particles {

namespace {

struct Cloud {
    const char* kind;           ///< column of the table and optics
    const char* rain = nullptr; ///< column of the rain, null where it is dry
};
const std::map<int, Cloud> waterClouds = {{1, {"cumulus"}},
                                          {2, {"altostratus"}},
                                          {3, {"stratus"}},
                                          {4, {"stratocumulus"}},
                                          {5, {"nimbostratus"}},
                                          {6, {"stratus", "rain_drizzle2"}},
                                          {7, {"nimbostratus", "rain_light5"}},
                                          {8, {"nimbostratus", "rain_moderate12.5"}},
                                          {9, {"cumulus", "rain_heavy25"}},
                                          {10, {"cumulus", "rain_extreme75"}}};

/// What a cloud's edge takes of its thickness to fall to 0 outside.
constexpr double waterEdge = 0.02;
constexpr double cirrusEdge = 0.1;

const ParticleTable& cloudTable() {
    static const ParticleTable table = ParticleTable::read(
        atmosphereResource("particles-clouds.csv"), ParticleTable::Kind::profile,
        {"cumulus", "altostratus", "stratus", "stratocumulus", "nimbostratus", "rain_drizzle2",
         "rain_light5", "rain_moderate12.5", "rain_heavy25", "rain_extreme75"});
    return table;
}

/// The rows of the table in which a cloud is, the last included.
std::pair<std::size_t, std::size_t> rowsOf(const char* kind) {
    const std::vector<double>& values = cloudTable().column(kind);
    auto wet = [](double value) { return value > 0.0; };
    const auto first = std::ranges::find_if(values, wet);
    if (first == values.end())
        throw InputError(Diagnostic{atmosphereResource("particles-clouds.csv").string(),
                                    "column " + std::string(kind), "no value above 0", "a cloud"});
    const auto behind = std::find_if(values.rbegin(), values.rend(), wet);
    return {static_cast<std::size_t>(first - values.begin()),
            static_cast<std::size_t>(values.rend() - behind) - 1};
}

void append(ParticleLayer& layer, double altitude_m, double extinction_per_m) {
    if (!layer.altitudes_m.empty() && altitude_m <= layer.altitudes_m.back())
        return;
    layer.altitudes_m.push_back(altitude_m);
    layer.extinction550_per_m.push_back(extinction_per_m);
}

double column(const ParticleLayer& layer) {
    double sum = 0.0;
    for (std::size_t i = 1; i < layer.altitudes_m.size(); ++i)
        sum += 0.5 * (layer.extinction550_per_m[i - 1] + layer.extinction550_per_m[i]) *
               (layer.altitudes_m[i] - layer.altitudes_m[i - 1]);
    return sum;
}

/// So that the optical depth is `extinction_per_m` times the thickness.
void scale(ParticleLayer& layer, double extinction_per_m, double thickness_m) {
    const double factor = extinction_per_m * thickness_m / column(layer);
    for (double& value : layer.extinction550_per_m)
        value *= factor;
}

/// A standard profile moved to its place, its edges falling to 0 outside of it.
ParticleLayer waterCloud(const ParticleSettings& settings, const Cloud& cloud,
                         const CloudPlace& place) {
    ParticleLayer layer;
    layer.name = std::string(cloud.kind) + " cloud";
    const auto [first, last] = rowsOf(cloud.kind);
    const double edge_m = waterEdge * place.thickness_m;
    if (place.base_m > 0.0)
        append(layer, std::max(0.0, place.base_m - edge_m), 0.0);
    for (std::size_t i = first; i <= last; ++i)
        append(layer,
               place.base_m + (cloudTable().first()[i] - place.ownBase_m) * place.thickness_m /
                                  place.ownThickness_m,
               cloudTable().column(cloud.kind)[i]);
    append(layer, place.base_m + place.thickness_m + edge_m, 0.0);
    if (settings.cloudExtinction_per_m > 0.0)
        scale(layer, settings.cloudExtinction_per_m, place.thickness_m);

    Optics optics = dryOptics(cloud.kind);
    layer.wavelengths_um = std::move(optics.wavelengths_um);
    layer.optics = std::move(optics.values);
    return layer;
}

ParticleLayer cirrus(const ParticleSettings& settings, const CloudPlace& place) {
    ParticleLayer layer;
    const bool thin = settings.cloudModel == 19;
    layer.name = thin ? "sub-visual cirrus" : "standard cirrus";
    const double edge_m = cirrusEdge * place.thickness_m;
    if (place.base_m > 0.0)
        append(layer, std::max(0.0, place.base_m - edge_m), 0.0);
    append(layer, place.base_m, 1.0);
    append(layer, place.base_m + place.thickness_m, 1.0);
    append(layer, place.base_m + place.thickness_m + edge_m, 0.0);

    // Of its own accord 0.14 km-1 for every kilometre of thickness.
    const double own_per_m = 0.14e-6 * place.thickness_m;
    scale(layer, settings.cloudExtinction_per_m > 0.0 ? settings.cloudExtinction_per_m : own_per_m,
          place.thickness_m);

    Optics optics = dryOptics(thin ? "cirrus_thin" : "cirrus_standard");
    layer.wavelengths_um = std::move(optics.wavelengths_um);
    layer.optics = std::move(optics.values);
    return layer;
}

/// Extinction of drops of the Marshall-Palmer distribution: pi N0 / L^3 with N0 = 8000 m-3 mm-1, L
/// = 41 R^-0.21 cm-1, hence 0.3647 R^0.63 km-1 for R in mm/h; the same at every wavelength to 28
/// um, half of it absorption.
double rainExtinction_per_m(double rate_mm_h) {
    return 0.36467e-3 * std::pow(rate_mm_h, 0.63);
}

/// Rain from the ground to the top of its cloud; it moves and stretches with the cloud, and with
/// the gap below it.
ParticleLayer rain(const Cloud& cloud, const CloudPlace& place) {
    ParticleLayer layer;
    layer.name = "rain";
    const std::vector<double>& rates = cloudTable().column(cloud.rain);
    const std::size_t last = rowsOf(cloud.kind).second;
    for (std::size_t i = 0; i <= last; ++i) {
        const double own_m = cloudTable().first()[i];
        const double altitude_m = own_m < place.ownBase_m
                                      ? own_m * place.base_m / place.ownBase_m
                                      : place.base_m + (own_m - place.ownBase_m) *
                                                           place.thickness_m / place.ownThickness_m;
        append(layer, altitude_m, rainExtinction_per_m(rates[i]));
    }
    append(layer, layer.altitudes_m.back() + waterEdge * place.thickness_m, 0.0);
    layer.wavelengths_um = {0.2, 40.0};
    layer.optics.assign(2, {1.0, 0.5, 0.85});
    return layer;
}

} // namespace

CloudPlace cloudPlace(const ParticleSettings& settings) {
    CloudPlace place;
    const auto water = waterClouds.find(settings.cloudModel);
    if (water != waterClouds.end()) {
        const auto [first, last] = rowsOf(water->second.kind);
        place.ownBase_m = cloudTable().first()[first];
        place.ownThickness_m = cloudTable().first()[last] - place.ownBase_m;
    } else {
        // Cirrus lie higher where the troposphere does: tropical, midlatitude summer and winter,
        // subarctic summer and winter, US standard.
        constexpr double bases_m[] = {11e3, 10e3, 8e3, 7e3, 5e3, 10e3};
        const auto atmosphere = settings.atmosphere.value_or(ModelAtmosphere::usStandard1976);
        place.ownBase_m = bases_m[static_cast<std::size_t>(atmosphere) - 1];
        place.ownThickness_m = settings.cloudModel == 19 ? 200.0 : 1000.0;
    }
    place.base_m = settings.cloudBase_m >= 0.0 ? settings.cloudBase_m : place.ownBase_m;
    place.thickness_m =
        settings.cloudThickness_m > 0.0 ? settings.cloudThickness_m : place.ownThickness_m;
    return place;
}

std::vector<ParticleLayer> clouds(const ParticleSettings& settings) {
    if (settings.cloudModel == 0)
        return {};
    const CloudPlace place = cloudPlace(settings);
    const auto water = waterClouds.find(settings.cloudModel);
    if (water == waterClouds.end())
        return {cirrus(settings, place)};
    std::vector<ParticleLayer> layers = {waterCloud(settings, water->second, place)};
    if (water->second.rain)
        layers.push_back(rain(water->second, place));
    return layers;
}

} // namespace irsg::particles
