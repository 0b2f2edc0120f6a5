#include "irsg/atmosphere/engine/DiffuseLight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "irsg/atmosphere/engine/PathIntegrator.h"
#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {

namespace {

constexpr std::size_t columnsAtOnce = 64; ///< layers of so many columns stay in the cache

/// Copies [level][few columns] into [level][all columns].
void put(const std::vector<double>& part, std::size_t count, std::size_t first, std::size_t all,
         std::vector<double>& whole) {
    for (std::size_t level = 0; level * count < part.size(); ++level)
        std::copy_n(part.data() + level * count, count, whole.data() + level * all + first);
}

/// The air at a level, per node.
struct LevelRows {
    const float *extinction, *scattering, *asymmetry, *forwardPeak;
    const double* planck;

    LevelRows(const NodeColumn& column, std::size_t level)
        : extinction(column.extinction(level).data()),
          scattering(column.scattering(level).data()),
          asymmetry(column.asymmetry(level).data()),
          forwardPeak(column.forwardPeak(level).data()),
          planck(column.planck(level).data()) {}
};

std::vector<LevelRows> levelRows(const NodeColumn& column) {
    std::vector<LevelRows> rows;
    for (std::size_t level = 0; level < column.air().levelCount(); ++level)
        rows.emplace_back(column, level);
    return rows;
}

/// `count` columns of a layer between two levels from `first` on, delta scaled.
IRSG_VECTOR_CLONES void scaledLayer(const LevelRows& below, const LevelRows& above, double half_m,
                                    std::size_t first, std::size_t count, double* __restrict depth,
                                    double* __restrict albedo, double* __restrict asymmetry) {
    const float *lowE = below.extinction + first, *highE = above.extinction + first;
    const float *lowS = below.scattering + first, *highS = above.scattering + first;
    const float *lowM = below.asymmetry + first, *highM = above.asymmetry + first;
    const float *lowF = below.forwardPeak + first, *highF = above.forwardPeak + first;
    const auto sum = [](float low, float high) {
        return static_cast<double>(low) + static_cast<double>(high);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const double forwardPeak = sum(lowF[i], highF[i]);
        const double e = std::max(sum(lowE[i], highE[i]) - forwardPeak, 0.0);
        const double s = std::max(sum(lowS[i], highS[i]) - forwardPeak, 0.0);
        const double ratio = s / (e > 0.0 ? e : 1.0);
        const double g = (sum(lowM[i], highM[i]) - forwardPeak) / (s > 0.0 ? s : 1.0);
        depth[i] = half_m * e;
        albedo[i] = ratio < 1.0 ? ratio : 1.0;
        asymmetry[i] = s > 0.0 ? std::min(std::max(g, -0.5), 0.5) : 0.0;
    }
}

/// The layers of the columns `first` to `first + count`.
TwoStreamLayers layersOf(const std::vector<double>& altitudes_m,
                         const std::vector<LevelRows>& levels,
                         const std::vector<double>& surfaceAlbedo, std::size_t first,
                         std::size_t count) {
    TwoStreamLayers layers(levels.size() - 1, count);
    for (std::size_t layer = 0; layer < layers.layers; ++layer)
        scaledLayer(levels[layer], levels[layer + 1],
                    0.5 * (altitudes_m[layer + 1] - altitudes_m[layer]), first, count,
                    &layers.opticalDepth[layer * count], &layers.albedo[layer * count],
                    &layers.asymmetry[layer * count]);
    std::copy_n(surfaceAlbedo.data() + first, count, layers.surfaceAlbedo.begin());
    return layers;
}

} // namespace

DiffuseLight::DiffuseLight(const NodeColumn& column, Ground ground)
    : column_(column), ground_(std::move(ground)) {
    for (const double wavenumber_per_cm : column_.wavenumbers_per_cm())
        albedo_.push_back(std::clamp(ground_.albedo.at(1e4 / wavenumber_per_cm), 0.0, 1.0));
}

TwoStreamFluxes DiffuseLight::solveThermal() const {
    const std::size_t all = column_.size();
    const std::size_t levels = column_.air().levelCount();
    TwoStreamFluxes fluxes{std::vector<double>(levels * all), std::vector<double>(levels * all)};
    const std::vector<LevelRows> rows = levelRows(column_);
    std::vector<double> ground(all);
    column_.planckAt(ground_.temperature_K, ground);
    for (std::size_t first = 0; first < all; first += columnsAtOnce) {
        const std::size_t count = std::min(columnsAtOnce, all - first);
        ThermalSource source;
        source.planck.resize(levels * count);
        for (std::size_t level = 0; level < levels; ++level)
            std::copy_n(rows[level].planck + first, count, source.planck.data() + level * count);
        source.surfacePlanck.assign(ground.data() + first, ground.data() + first + count);
        const TwoStreamFluxes part = thermalFluxes(
            layersOf(column_.air().altitudes_m(), rows, albedo_, first, count), source);
        put(part.up, count, first, all, fluxes.up);
        put(part.down, count, first, all, fluxes.down);
    }
    return fluxes;
}

DiffuseLight::Sunlight DiffuseLight::solveSunlight(const SunPaths& sun) const {
    const std::size_t all = column_.size();
    const std::size_t levels = column_.air().levelCount();
    Sunlight light;
    light.elevation_rad = sun.elevation_rad();
    light.strength = sun.strength();
    for (std::vector<double>* values :
         {&light.direct, &light.scaled, &light.fluxes.up, &light.fluxes.down})
        values->assign(levels * all, 0.0);

    // The beam at every level; optical depths along it are kept for the slant of the layers.
    std::vector<double> scaledDepth(levels * all, 0.0);
    std::vector<double> forwardPeak(all);
    for (std::size_t level = 0; level < levels; ++level) {
        const double part = sun.strength() * sun.part(level);
        const std::vector<double>& weights = sun.weights(level);
        double* direct = &light.direct[level * all];
        double* scaled = &light.scaled[level * all];
        double* depth = &scaledDepth[level * all];
        opticalDepth(column_, weights, Depth::extinction, {direct, all});
        std::ranges::fill(forwardPeak, 0.0);
        for (std::size_t from = 0; from < levels; ++from) {
            const float* row = column_.forwardPeak(from).data();
            if (weights[from] > 0.0)
                for (std::size_t i = 0; i < all; ++i)
                    forwardPeak[i] += weights[from] * static_cast<double>(row[i]);
        }
        const double* above = column_.sun().data();
        for (std::size_t i = 0; i < all; ++i) {
            depth[i] = std::max(direct[i] - forwardPeak[i], 0.0);
            scaled[i] = part * above[i] * (1.0 - vectorAbsorbed(depth[i]));
            direct[i] = part * above[i] * (1.0 - vectorAbsorbed(direct[i]));
        }
    }

    const std::vector<LevelRows> rows = levelRows(column_);
    for (std::size_t first = 0; first < all; first += columnsAtOnce) {
        const std::size_t count = std::min(columnsAtOnce, all - first);
        const TwoStreamLayers air =
            layersOf(column_.air().altitudes_m(), rows, albedo_, first, count);
        SolarBeam beam;
        beam.sinElevation = sun.sinElevation();
        beam.irradiance.resize(levels * count);
        beam.slant.resize(air.layers * count);
        for (std::size_t level = 0; level < levels; ++level)
            std::copy_n(&light.scaled[level * all + first], count, &beam.irradiance[level * count]);
        for (std::size_t layer = 0; layer < air.layers; ++layer) {
            const double* below = &scaledDepth[layer * all + first];
            const double* above = &scaledDepth[(layer + 1) * all + first];
            for (std::size_t i = 0; i < count; ++i) {
                const double vertical = air.opticalDepth[layer * count + i];
                const double slant = vertical > 1e-14 ? (below[i] - above[i]) / vertical : 1.0;
                beam.slant[layer * count + i] = std::clamp(slant, 1.0, 2000.0);
            }
        }
        const TwoStreamFluxes part = solarFluxes(air, beam);
        put(part.up, count, first, all, light.fluxes.up);
        put(part.down, count, first, all, light.fluxes.down);
    }
    return light;
}

std::shared_ptr<const TwoStreamFluxes> DiffuseLight::thermal() const {
    const std::lock_guard lock(mutex_);
    if (!thermal_)
        thermal_ = std::make_shared<const TwoStreamFluxes>(solveThermal());
    return thermal_;
}

std::shared_ptr<const DiffuseLight::Sunlight> DiffuseLight::sunlight(const SunPaths& sun) const {
    const std::lock_guard lock(mutex_);
    return sunlight_.of(
        [&](const auto& kept) {
            return kept->elevation_rad == sun.elevation_rad() && kept->strength == sun.strength();
        },
        [&] { return std::make_shared<const Sunlight>(solveSunlight(sun)); });
}

void DiffuseLight::scattered(std::size_t level, const TwoStreamFluxes& thermal, const Sunlight* sun,
                             std::span<double> mean, std::span<double> slope) const {
    constexpr double perPi = std::numbers::inv_pi;
    const std::size_t n = column_.size();
    const float* scattering = column_.scattering(level).data();
    const float* asymmetry = column_.asymmetry(level).data();
    std::ranges::fill(mean, 0.0);
    std::ranges::fill(slope, 0.0);
    const auto add = [&](const TwoStreamFluxes& fluxes, double meanPerFlux) {
        const double* up = &fluxes.up[level * n];
        const double* down = &fluxes.down[level * n];
        for (std::size_t i = 0; i < n; ++i) {
            mean[i] += meanPerFlux * static_cast<double>(scattering[i]) * (up[i] + down[i]);
            slope[i] += 0.75 * perPi * static_cast<double>(asymmetry[i]) * (up[i] - down[i]);
        }
    };
    add(thermal, 0.5 * perPi);
    if (sun)
        add(sun->fluxes, 0.25 * std::numbers::sqrt3 * perPi);
    for (std::size_t i = 0; i < n; ++i)
        slope[i] = std::clamp(slope[i], -mean[i], mean[i]);
}

void interpolateLevels(const AtmosphericColumn& air, std::span<const double> levels,
                       double altitude_m, std::span<double> out) {
    const std::size_t n = out.size();
    const std::vector<double>& z = air.altitudes_m();
    const auto [layer, f] = air.placeOf(altitude_m);
    const std::size_t last = z.size() - 1;
    const std::size_t before = layer > 0 ? layer - 1 : 0;
    const std::size_t after = std::min(layer + 2, last);
    const double h = z[layer + 1] - z[layer];
    const double hBefore = z[layer] - z[before];
    const double hAfter = z[after] - z[layer + 1];

    // Hermite's base.
    const double onLower = (1.0 + 2.0 * f) * (1.0 - f) * (1.0 - f);
    const double onLowerSlope = f * (1.0 - f) * (1.0 - f) * h;
    const double onUpper = f * f * (3.0 - 2.0 * f);
    const double onUpperSlope = f * f * (f - 1.0) * h;
    // Slope at a level between two pieces: 0 at extremes, else a weighted harmonic mean.
    const auto slope = [](double left, double right, double hLeft, double hRight) {
        if (left * right <= 0.0)
            return 0.0;
        const double a = hLeft + 2.0 * hRight, b = 2.0 * hLeft + hRight;
        return (a + b) / (b / left + a / right);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double lower = levels[layer * n + i];
        const double upper = levels[(layer + 1) * n + i];
        const double middle = (upper - lower) / h;
        const double left = hBefore > 0.0 ? (lower - levels[before * n + i]) / hBefore : middle;
        const double right = hAfter > 0.0 ? (levels[after * n + i] - upper) / hAfter : middle;
        out[i] = onLower * lower + onUpper * upper +
                 onLowerSlope * slope(left, middle, hBefore > 0.0 ? hBefore : h, h) +
                 onUpperSlope * slope(middle, right, h, hAfter > 0.0 ? hAfter : h);
    }
}

} // namespace irsg
