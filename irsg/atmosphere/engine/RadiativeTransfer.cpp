#include "irsg/atmosphere/engine/RadiativeTransfer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <optional>

#include "irsg/atmosphere/engine/AtmosphericColumn.h"
#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/DiffuseLight.h"
#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/atmosphere/engine/PathIntegrator.h"
#include "irsg/atmosphere/engine/SunPaths.h"
#include "irsg/core/Errors.h"
#include "irsg/core/RecentlyUsed.h"

namespace irsg {

namespace {

constexpr std::size_t nodesAtOnce = 2048; ///< nodes that are computed and kept together
constexpr std::size_t blocksKept = 24;    ///< of up to 18 MB each, with sun and diffuse light
constexpr std::size_t sunsKept = 8;
constexpr std::size_t raysKept = 16;
constexpr std::size_t litKept = 2; ///< suns whose sources a block keeps

/// The ray of a path, and what every level counts along it.
struct PathRay {
    AtmosphericPath path;
    RayPath ray;
    std::vector<double> weights;
};

/// Source functions under one sun: what does not depend on the azimuth, and its beam.
struct LitSources {
    LitSources(const NodeColumn& column, std::shared_ptr<const DiffuseLight::Sunlight> sun,
               ScatteredEmission diffuse, BeamEmission beam)
        : light(std::move(sun)),
          even(column, std::move(diffuse)),
          beams(column, column.scattererCount(), std::move(beam)) {}

    std::shared_ptr<const DiffuseLight::Sunlight> light;
    LevelSources even;
    BeamSources beams;
};

/// Nodes that belong together and what is known of the air at them.
struct Block {
    Block(const AtmosphericColumn& air, std::vector<std::uint32_t> nodes,
          std::vector<double> wavenumbers, double sunWidth_per_cm, DiffuseLight::Ground ground)
        : column(air, std::move(nodes), std::move(wavenumbers), sunWidth_per_cm),
          light(column, std::move(ground)) {}

    NodeColumn column;
    DiffuseLight light;
    /// Source functions without the sun, and those of the last few suns: see State::integratePath.
    mutable CallOnceFast sunlessOnce;
    mutable std::optional<LevelSources> sunless;
    mutable std::mutex litMutex;
    mutable RecentlyUsed<std::shared_ptr<const LitSources>> lit{litKept};
};

/// One of the parts that extinction is made of, m-1 at a node of a level of air.
using Component = std::function<double(const NodeColumn&, std::size_t level, std::size_t node)>;

Component componentCalled(const std::string& name) {
    for (std::size_t gas = 0; gas < lineGasCount; ++gas)
        if (name == gasNames[gas])
            return [gas = static_cast<Gas>(gas)](const NodeColumn& column, std::size_t level,
                                                 std::size_t node) {
                const AtmosphericState& air = column.air().level(level);
                return column.air().gases().crossSection_cm2(column.nodes()[node], gas, air) *
                       1e-4 * air.density_per_m3(gas);
            };
    for (std::size_t which = 0; which < continuumCount; ++which)
        if (name == continuumNames[which])
            return [which = static_cast<Continuum>(which)](const NodeColumn& column,
                                                           std::size_t level, std::size_t node) {
                return continuumAbsorption_per_m(which, column.air().level(level),
                                                 column.wavenumbers_per_cm()[node]);
            };
    if (name == "Rayleigh")
        return [](const NodeColumn& column, std::size_t level, std::size_t node) {
            return rayleighScattering_per_m(column.air().level(level),
                                            column.wavenumbers_per_cm()[node]);
        };
    if (name == "particles")
        return [](const NodeColumn& column, std::size_t level, std::size_t node) {
            const AtmosphericColumn& air = column.air();
            double sum = 0.0;
            for (std::size_t kind = 0; kind < air.particles().size(); ++kind)
                sum += air.particleExtinction550_per_m(kind, level) *
                       air.particles()[kind]
                           .opticsAt(1e4 / column.wavenumbers_per_cm()[node])
                           .extinction;
            return sum;
        };
    throw LogicError("the air has no component called " + name);
}

} // namespace

struct RadiativeTransfer::State {
    State(AtmosphericModel model, std::shared_ptr<const GasTable> table)
        : air(std::move(model)),
          gases(std::move(table)),
          column(air.profile, air.particles, gases),
          tracer(air.profile, column.altitudes_m()) {}

    AtmosphericModel air;
    std::shared_ptr<const GasTable> gases;
    AtmosphericColumn column;
    RayTracer tracer;
    std::mutex mutex;
    RecentlyUsed<std::shared_ptr<const Block>> blocks{blocksKept};
    RecentlyUsed<std::shared_ptr<const SunPaths>> suns{sunsKept};
    RecentlyUsed<std::shared_ptr<const PathRay>> rays{raysKept};

    std::shared_ptr<const Block> block(std::span<const std::uint32_t> nodes,
                                       std::span<const double> wavenumbers_per_cm) {
        const std::lock_guard lock(mutex);
        return blocks.of(
            [&](const auto& kept) {
                return std::ranges::equal(kept->column.nodes(), nodes) &&
                       std::ranges::equal(kept->column.wavenumbers_per_cm(), wavenumbers_per_cm);
            },
            [&] {
                return std::make_shared<const Block>(
                    column, std::vector<std::uint32_t>(nodes.begin(), nodes.end()),
                    std::vector<double>(wavenumbers_per_cm.begin(), wavenumbers_per_cm.end()),
                    static_cast<double>(air.resolution_per_cm),
                    DiffuseLight::Ground{air.groundTemperature_K, air.groundAlbedo});
            });
    }

    std::shared_ptr<const SunPaths> sunPaths(const SunPosition& sun) {
        const std::lock_guard lock(mutex);
        return suns.of(
            [&](const auto& kept) {
                return kept->elevation_rad() == sun.elevation_rad &&
                       kept->strength() == sun.strength();
            },
            [&] { return std::make_shared<const SunPaths>(tracer, sun); });
    }

    /// Transmittance, radiance and scattering of a path are usually asked for together.
    std::shared_ptr<const PathRay> ray(const AtmosphericPath& path) {
        const std::lock_guard lock(mutex);
        return rays.of(
            [&](const auto& kept) {
                return kept->path.sensorAltitude_m == path.sensorAltitude_m &&
                       kept->path.targetAltitude_m == path.targetAltitude_m &&
                       kept->path.range_m == path.range_m;
            },
            [&] {
                RayPath traced = tracer.between(path);
                std::vector<double> weights = levelWeights(traced, column.levelCount());
                return std::make_shared<const PathRay>(
                    PathRay{path, std::move(traced), std::move(weights)});
            });
    }

    /// Calls `compute(block, values of the block)` for all nodes of a set.
    template <typename Compute>
    std::vector<double> forEachBlock(const NodeSet& set, Compute compute) {
        if (set.nodes.size() != set.wavenumbers_per_cm.size())
            throw LogicError("a set of nodes has not as many wavenumbers as nodes");
        std::vector<double> values(set.nodes.size());
        for (std::size_t first = 0; first < values.size(); first += nodesAtOnce) {
            const std::size_t count = std::min(nodesAtOnce, values.size() - first);
            const auto own = block(std::span(set.nodes).subspan(first, count),
                                   std::span(set.wavenumbers_per_cm).subspan(first, count));
            compute(*own, std::span(values).subspan(first, count));
        }
        return values;
    }

    /// Diffuse light that the air scatters into a path, see `ScatteringMode`; `light` is null in
    /// the dark. Whatever it refers to must outlive it.
    ScatteredEmission scattered(const Block& block,
                                const std::shared_ptr<const DiffuseLight::Sunlight>& light) const {
        std::shared_ptr<const TwoStreamFluxes> thermal;
        if (air.scattering == ScatteringMode::twoStream)
            thermal = block.light.thermal();
        return [&block, light, thermal](std::size_t level, std::span<double> mean,
                                        std::span<double> slope) {
            if (thermal) {
                block.light.scattered(level, *thermal, light.get(), mean, slope);
                return;
            }
            // What surrounds the air is as warm as the air.
            std::ranges::transform(block.column.scattering(level), block.column.planck(level),
                                   mean.begin(), [](float scattering, double planck) {
                                       return static_cast<double>(scattering) * planck;
                                   });
            std::ranges::fill(slope, 0.0);
        };
    }

    /// The beam itself, scattered once. Where a diffuse field is known, the beam holds what was
    /// scattered nearly forward, which that field lacks.
    BeamEmission beamOf(const Block& block,
                        const std::shared_ptr<const DiffuseLight::Sunlight>& light) const {
        const bool isScaled = air.scattering == ScatteringMode::twoStream;
        return [&block, light, isScaled](std::size_t level, std::size_t kind,
                                         std::span<double> emission) {
            if (!block.column.scatteringBy(kind, level, emission))
                return false;
            const double* beam =
                (isScaled ? light->scaled : light->direct).data() + level * emission.size();
            for (std::size_t i = 0; i < emission.size(); ++i)
                emission[i] *= 0.25 * std::numbers::inv_pi * beam[i];
            return true;
        };
    }

    std::shared_ptr<const LitSources>
    litSources(const Block& block,
               const std::shared_ptr<const DiffuseLight::Sunlight>& light) const {
        const std::lock_guard lock(block.litMutex);
        return block.lit.of([&](const auto& kept) { return kept->light == light; },
                            [&] {
                                return std::make_shared<const LitSources>(block.column, light,
                                                                          scattered(block, light),
                                                                          beamOf(block, light));
                            });
    }

    /// Sources depend on the level and the sun's elevation alone, and are kept.
    PathLight integratePath(const Block& block, const RayPath& ray,
                            const std::shared_ptr<const DiffuseLight::Sunlight>& light) const {
        if (light) {
            const auto sources = litSources(block, light);
            return irsg::integratePath(sources->even, ray, &sources->beams);
        }
        block.sunlessOnce.call([&] { block.sunless.emplace(block.column, scattered(block, {})); });
        return irsg::integratePath(*block.sunless, ray);
    }

    /// Light along a ray at all nodes; `behind(block, along, light, values)` adds what is seen at
    /// its far end.
    template <typename Behind>
    DirectedLight directed(const NodeSet& set, const RayPath& ray, const SunPosition& sun,
                           Behind behind) {
        DirectedLight all;
        all.even.assign(set.nodes.size(), 0.0);
        const auto paths = sunPaths(sun);
        std::size_t first = 0;
        forEachBlock(set, [&](const Block& block, std::span<double> values) {
            const auto light = sunlight(block, *paths);
            const PathLight along = integratePath(block, ray, light);
            std::ranges::copy(along.radiance, values.begin());
            behind(block, along, light.get(), values);
            std::ranges::copy(values, all.even.begin() + static_cast<std::ptrdiff_t>(first));
            all.beams.resize(along.beams.size(), std::vector<double>(set.nodes.size(), 0.0));
            for (std::size_t kind = 0; kind < along.beams.size(); ++kind)
                std::ranges::copy(along.beams[kind],
                                  all.beams[kind].begin() + static_cast<std::ptrdiff_t>(first));
            first += values.size();
        });
        return all;
    }

    std::shared_ptr<const DiffuseLight::Sunlight> sunlight(const Block& block,
                                                           const SunPaths& paths) const {
        return paths.isAnyLit() ? block.light.sunlight(paths) : nullptr;
    }
};

RadiativeTransfer::RadiativeTransfer(AtmosphericModel air, std::shared_ptr<const GasTable> gases)
    : state_(std::make_unique<State>(std::move(air), std::move(gases))) {}

RadiativeTransfer::~RadiativeTransfer() = default;

const AtmosphericModel& RadiativeTransfer::air() const {
    return state_->air;
}

const GasTable& RadiativeTransfer::gases() const {
    return *state_->gases;
}

const RayTracer& RadiativeTransfer::tracer() const {
    return state_->tracer;
}

std::vector<double> RadiativeTransfer::transmittance(const NodeSet& set,
                                                     const AtmosphericPath& path) const {
    const auto own = state_->ray(path);
    const std::vector<double>& weights = own->weights;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::extinction, values);
        turnToTransmittance(values);
    });
}

std::vector<double> RadiativeTransfer::scatteringOpticalDepth(const NodeSet& set,
                                                              const AtmosphericPath& path) const {
    const auto own = state_->ray(path);
    const std::vector<double>& weights = own->weights;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::scattering, values);
    });
}

std::vector<double> RadiativeTransfer::componentTransmittance(const NodeSet& set,
                                                              const AtmosphericPath& path,
                                                              const std::string& component) const {
    const Component absorption_per_m = componentCalled(component);
    const auto own = state_->ray(path);
    const std::vector<double>& weights = own->weights;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        for (std::size_t node = 0; node < values.size(); ++node) {
            double depth = 0.0;
            for (std::size_t level = 0; level < weights.size(); ++level)
                if (weights[level] > 0.0)
                    depth += weights[level] * absorption_per_m(block.column, level, node);
            values[node] = std::exp(-depth);
        }
    });
}

DirectedLight RadiativeTransfer::pathLight(const NodeSet& set, const AtmosphericPath& path,
                                           const SunPosition& sun) const {
    const auto own = state_->ray(path);
    if (own->ray.segments.empty())
        return {0.0, std::vector<double>(set.nodes.size(), 0.0), {}};
    DirectedLight light =
        state_->directed(set, own->ray, sun, [](const auto&, const auto&, const auto*, auto) {});
    light.sightElevation_rad = std::asin(own->ray.segments.front().sinElevation);
    return light;
}

DirectedLight RadiativeTransfer::skyLight(const NodeSet& set, const LineOfSight& sight,
                                          const SunPosition& sun) const {
    const RayPath ray = state_->tracer.along(sight);
    if (ray.segments.empty() && ray.end == RayPath::End::space)
        return {sight.elevation_rad, std::vector<double>(set.nodes.size(), 0.0), {}};
    DirectedLight light = state_->directed(
        set, ray, sun,
        [&](const Block& block, const PathLight& along, const DiffuseLight::Sunlight* sunlight,
            std::span<double> values) {
            if (ray.end != RayPath::End::ground)
                return;
            // The ground is Lambertian: what leaves it, emitted and reflected, is the upward flux.
            const auto thermal = block.light.thermal();
            for (std::size_t i = 0; i < values.size(); ++i) {
                const double leaving = thermal->up[i] + (sunlight ? sunlight->fluxes.up[i] : 0.0);
                values[i] += along.transmittance[i] * leaving * std::numbers::inv_pi;
            }
        });
    light.sightElevation_rad = sight.elevation_rad;
    return light;
}

std::vector<double> RadiativeTransfer::towards(const NodeSet& set, const DirectedLight& light,
                                               double sunElevation_rad,
                                               double relativeAzimuth_rad) const {
    if (light.beams.empty())
        return light.even;
    const double cosine =
        SunAngle{sunElevation_rad, light.sightElevation_rad, relativeAzimuth_rad}.cosine();
    std::size_t first = 0;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        std::copy_n(light.even.begin() + static_cast<std::ptrdiff_t>(first), values.size(),
                    values.begin());
        std::vector<double> phase(values.size());
        for (std::size_t kind = 0; kind < light.beams.size(); ++kind) {
            block.column.phaseOf(kind, cosine, phase);
            const double* beam = light.beams[kind].data() + first;
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += phase[i] * beam[i];
        }
        first += values.size();
    });
}

std::vector<double> RadiativeTransfer::pathRadiance(const NodeSet& set, const AtmosphericPath& path,
                                                    const SunPosition& sun) const {
    return towards(set, pathLight(set, path, sun), sun.elevation_rad,
                   path.azimuth_rad - sun.azimuth_rad);
}

std::vector<double> RadiativeTransfer::backgroundRadiance(const NodeSet& set,
                                                          const LineOfSight& sight,
                                                          const SunPosition& sun) const {
    return towards(set, skyLight(set, sight, sun), sun.elevation_rad,
                   sight.azimuth_rad - sun.azimuth_rad);
}

std::vector<double> RadiativeTransfer::solarIrradiance(const NodeSet& set, double altitude_m,
                                                       const SunPosition& sun) const {
    const auto [visible, ray] = state_->tracer.sunbeam(altitude_m, sun.elevation_rad);
    const double part = visible * sun.strength();
    if (part <= 0.0)
        return std::vector<double>(set.nodes.size(), 0.0);
    const std::vector<double> weights = levelWeights(ray, state_->column.levelCount());
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::extinction, values);
        turnToTransmittance(values);
        std::ranges::transform(
            values, block.column.sun(), values.begin(),
            [part](double transmitted, double above) { return part * transmitted * above; });
    });
}

std::vector<double> RadiativeTransfer::upwardFlux(const NodeSet& set, double altitude_m,
                                                  const SunPosition& sun) const {
    const auto paths = state_->sunPaths(sun);
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        interpolateLevels(state_->column, block.light.thermal()->up, altitude_m, values);
        const auto light = state_->sunlight(block, *paths);
        if (!light)
            return;
        std::vector<double> solar(values.size());
        interpolateLevels(state_->column, light->fluxes.up, altitude_m, solar);
        std::ranges::transform(values, solar, values.begin(), std::plus());
    });
}

std::vector<double> RadiativeTransfer::downwardFlux(const NodeSet& set, double altitude_m,
                                                    const SunPosition& sun) const {
    const auto paths = state_->sunPaths(sun);
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        interpolateLevels(state_->column, block.light.thermal()->down, altitude_m, values);
        const auto light = state_->sunlight(block, *paths);
        if (!light)
            return;
        // Light scattered nearly forward is diffuse here, although the solution has it in the beam.
        const std::size_t n = values.size(), levels = state_->column.levelCount();
        std::vector<double> solar(levels * n); // of the levels that are next to the altitude
        const std::size_t layer = state_->column.placeOf(altitude_m).layer;
        const std::size_t first = layer > 0 ? layer - 1 : 0, last = std::min(layer + 2, levels - 1);
        for (std::size_t i = first * n; i < (last + 1) * n; ++i)
            solar[i] = light->fluxes.down[i] +
                       paths->sinElevation() * (light->scaled[i] - light->direct[i]);
        std::vector<double> here(values.size());
        interpolateLevels(state_->column, solar, altitude_m, here);
        std::ranges::transform(values, here, values.begin(), std::plus());
    });
}

} // namespace irsg
