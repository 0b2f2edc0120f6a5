#include "irsg/atmosphere/engine/RadiativeTransfer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <list>
#include <mutex>
#include <numbers>
#include <optional>

#include "irsg/atmosphere/engine/AirColumn.h"
#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/DiffuseLight.h"
#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/atmosphere/engine/PathIntegrator.h"
#include "irsg/atmosphere/engine/SunPaths.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

constexpr std::size_t nodesAtOnce = 2048; ///< nodes that are computed and kept together
constexpr std::size_t blocksKept = 24;    ///< of up to 18 MB each, with sun and diffuse light
constexpr std::size_t sunsKept = 8;
constexpr std::size_t raysKept = 16;

/// The ray of a path, and what every level counts along it.
struct PathRay {
    AirPath path;
    RayPath ray;
    std::vector<double> weights;
};

/// Nodes that belong together and what is known of the air at them.
struct Block {
    Block(const AirColumn& air, std::vector<std::uint32_t> nodes, std::vector<double> wavenumbers,
          double sunWidth_cm, DiffuseLight::Ground ground)
        : column(air, std::move(nodes), std::move(wavenumbers), sunWidth_cm),
          light(column, std::move(ground)) {}

    NodeColumn column;
    DiffuseLight light;
    /// Source functions without the sun, see State::lightAlong.
    mutable Once darkOnce;
    mutable std::optional<LevelSources> dark;
};

/// One of the parts that extinction is made of, m-1 at a node of a level of air.
using Component = std::function<double(const NodeColumn&, std::size_t level, std::size_t node)>;

Component componentCalled(const std::string& name) {
    for (std::size_t gas = 0; gas < lineGasCount; ++gas)
        if (name == gasNames[gas])
            return [gas = static_cast<Gas>(gas)](const NodeColumn& column, std::size_t level,
                                                 std::size_t node) {
                const AirState& air = column.air().level(level);
                return column.air().gases().crossSection_cm2(column.nodes()[node], gas, air) *
                       1e-4 * air.density_per_m3(gas);
            };
    for (std::size_t which = 0; which < continuumCount; ++which)
        if (name == continuumNames[which])
            return [which = static_cast<Continuum>(which)](const NodeColumn& column,
                                                           std::size_t level, std::size_t node) {
                return continuumAbsorption_per_m(which, column.air().level(level),
                                                 column.wavenumbers_cm()[node]);
            };
    if (name == "Rayleigh")
        return [](const NodeColumn& column, std::size_t level, std::size_t node) {
            return rayleighScattering_per_m(column.air().level(level),
                                            column.wavenumbers_cm()[node]);
        };
    if (name == "particles")
        return [](const NodeColumn& column, std::size_t level, std::size_t node) {
            const AirColumn& air = column.air();
            double sum = 0.0;
            for (std::size_t kind = 0; kind < air.particles().size(); ++kind)
                sum +=
                    air.particleExtinction550_per_m(kind, level) *
                    air.particles()[kind].opticsAt(1e4 / column.wavenumbers_cm()[node]).extinction;
            return sum;
        };
    throw LogicError("the air has no component called " + name);
}

} // namespace

struct RadiativeTransfer::State {
    State(AirModel model, std::shared_ptr<const GasTable> table)
        : air(std::move(model)),
          gases(std::move(table)),
          column(air.profile, air.particles, gases),
          tracer(air.profile, column.altitudes_m()) {}

    AirModel air;
    std::shared_ptr<const GasTable> gases;
    AirColumn column;
    RayTracer tracer;
    std::mutex mutex;
    std::list<std::shared_ptr<const Block>> blocks; ///< the latest first
    std::list<std::shared_ptr<const SunPaths>> suns;
    std::list<std::shared_ptr<const PathRay>> rays;

    std::shared_ptr<const Block> block(std::span<const std::uint32_t> nodes,
                                       std::span<const double> wavenumbers_cm) {
        const std::lock_guard lock(mutex);
        const auto known = std::ranges::find_if(blocks, [&](const auto& kept) {
            return std::ranges::equal(kept->column.nodes(), nodes) &&
                   std::ranges::equal(kept->column.wavenumbers_cm(), wavenumbers_cm);
        });
        if (known != blocks.end()) {
            blocks.splice(blocks.begin(), blocks, known);
        } else {
            blocks.push_front(std::make_shared<const Block>(
                column, std::vector<std::uint32_t>(nodes.begin(), nodes.end()),
                std::vector<double>(wavenumbers_cm.begin(), wavenumbers_cm.end()),
                static_cast<double>(air.resolution_cm),
                DiffuseLight::Ground{air.groundTemperature_K, air.groundAlbedo}));
            if (blocks.size() > blocksKept)
                blocks.pop_back();
        }
        return blocks.front();
    }

    std::shared_ptr<const SunPaths> sunPaths(double elevation_rad) {
        const std::lock_guard lock(mutex);
        const auto known = std::ranges::find_if(
            suns, [&](const auto& kept) { return kept->elevation_rad() == elevation_rad; });
        if (known != suns.end()) {
            suns.splice(suns.begin(), suns, known);
        } else {
            suns.push_front(std::make_shared<const SunPaths>(tracer, elevation_rad));
            if (suns.size() > sunsKept)
                suns.pop_back();
        }
        return suns.front();
    }

    /// Transmittance, radiance and scattering of a path are usually asked for together.
    std::shared_ptr<const PathRay> ray(const AirPath& path) {
        const std::lock_guard lock(mutex);
        const auto known = std::ranges::find_if(rays, [&](const auto& kept) {
            return kept->path.sensorAltitude_m == path.sensorAltitude_m &&
                   kept->path.targetAltitude_m == path.targetAltitude_m &&
                   kept->path.range_m == path.range_m;
        });
        if (known != rays.end()) {
            rays.splice(rays.begin(), rays, known);
        } else {
            RayPath traced = tracer.between(path);
            std::vector<double> weights = levelWeights(traced, column.levelCount());
            rays.push_front(std::make_shared<const PathRay>(
                PathRay{path, std::move(traced), std::move(weights)}));
            if (rays.size() > raysKept)
                rays.pop_back();
        }
        return rays.front();
    }

    /// Calls `compute(block, values of the block)` for all nodes of a set.
    template <typename Compute>
    std::vector<double> forEachBlock(const NodeSet& set, Compute compute) {
        if (set.nodes.size() != set.wavenumbers_cm.size())
            throw LogicError("a set of nodes has not as many wavenumbers as nodes");
        std::vector<double> values(set.nodes.size());
        for (std::size_t first = 0; first < values.size(); first += nodesAtOnce) {
            const std::size_t count = std::min(nodesAtOnce, values.size() - first);
            const auto own = block(std::span(set.nodes).subspan(first, count),
                                   std::span(set.wavenumbers_cm).subspan(first, count));
            compute(*own, std::span(values).subspan(first, count));
        }
        return values;
    }

    /// What the air scatters into a path, see `ScatteringMode`; `light` is null in the dark.
    /// Whatever it refers to must outlive it.
    ScatteredEmission scattered(const Block& block,
                                const std::shared_ptr<const DiffuseLight::Sunlight>& light,
                                const SunAngle& angle) const {
        std::shared_ptr<const TwoStreamFluxes> thermal;
        if (air.scattering == ScatteringMode::twoStream)
            thermal = block.light.thermal();
        NodeColumn::Phases phases;
        if (light)
            phases = block.column.phases(angle);
        return [&block, light, thermal, phases = std::move(phases)](
                   std::size_t level, std::span<double> mean, std::span<double> slope) {
            if (thermal) {
                block.light.scattered(level, *thermal, light.get(), mean, slope);
            } else {
                // What surrounds the air is as warm as the air.
                std::ranges::transform(block.column.scattering(level), block.column.planck(level),
                                       mean.begin(), [](float scattering, double planck) {
                                           return static_cast<double>(scattering) * planck;
                                       });
                std::ranges::fill(slope, 0.0);
            }
            if (!light)
                return;
            // The beam itself, scattered once. Where a diffuse field is known, the beam holds what
            // was scattered nearly forward, which that field lacks.
            const std::size_t n = mean.size();
            std::vector<double> towards(n);
            block.column.scatteringTowards(level, phases, towards);
            const double* beam = (thermal ? light->scaled : light->direct).data() + level * n;
            for (std::size_t i = 0; i < n; ++i)
                mean[i] += 0.25 * std::numbers::inv_pi * towards[i] * beam[i];
        };
    }

    /// In the dark sources depend on the level alone, and are kept.
    PathLight lightAlong(const Block& block, const RayPath& ray,
                         const std::shared_ptr<const DiffuseLight::Sunlight>& light,
                         const SunAngle& angle) const {
        if (light)
            return irsg::lightAlong(block.column, ray, scattered(block, light, angle));
        block.darkOnce.call([&] { block.dark.emplace(block.column, scattered(block, {}, {})); });
        return irsg::lightAlong(*block.dark, ray);
    }

    std::shared_ptr<const DiffuseLight::Sunlight> sunlight(const Block& block,
                                                           const SunPaths& paths) const {
        return paths.isAnyLit() ? block.light.sunlight(paths) : nullptr;
    }
};

RadiativeTransfer::RadiativeTransfer(AirModel air, std::shared_ptr<const GasTable> gases)
    : state_(std::make_unique<State>(std::move(air), std::move(gases))) {}

RadiativeTransfer::~RadiativeTransfer() = default;

const AirModel& RadiativeTransfer::air() const {
    return state_->air;
}

const GasTable& RadiativeTransfer::gases() const {
    return *state_->gases;
}

const RayTracer& RadiativeTransfer::tracer() const {
    return state_->tracer;
}

std::vector<double> RadiativeTransfer::transmittance(const NodeSet& set,
                                                     const AirPath& path) const {
    const auto own = state_->ray(path);
    const std::vector<double>& weights = own->weights;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::extinction, values);
        turnToTransmittance(values);
    });
}

std::vector<double> RadiativeTransfer::scatteringOpticalDepth(const NodeSet& set,
                                                              const AirPath& path) const {
    const auto own = state_->ray(path);
    const std::vector<double>& weights = own->weights;
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::scattering, values);
    });
}

std::vector<double> RadiativeTransfer::componentTransmittance(const NodeSet& set,
                                                              const AirPath& path,
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

std::vector<double> RadiativeTransfer::pathRadiance(const NodeSet& set, const AirPath& path,
                                                    const SunPosition& sun) const {
    const auto own = state_->ray(path);
    const RayPath& ray = own->ray;
    if (ray.segments.empty())
        return std::vector<double>(set.nodes.size(), 0.0);
    const auto paths = state_->sunPaths(sun.elevation_rad);
    const SunAngle angle{sun.elevation_rad, std::asin(ray.segments.front().sinElevation), {}};
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        const auto light = state_->sunlight(block, *paths);
        const PathLight along = state_->lightAlong(block, ray, light, angle);
        std::ranges::copy(along.radiance, values.begin());
    });
}

std::vector<double> RadiativeTransfer::backgroundRadiance(const NodeSet& set,
                                                          const LineOfSight& sight,
                                                          const SunPosition& sun) const {
    const RayPath ray = state_->tracer.along(sight);
    if (ray.segments.empty() && ray.end == RayPath::End::space)
        return std::vector<double>(set.nodes.size(), 0.0);
    const auto paths = state_->sunPaths(sun.elevation_rad);
    const SunAngle angle{sun.elevation_rad, sight.elevation_rad,
                         sight.azimuth_rad - sun.azimuth_rad};
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        const auto light = state_->sunlight(block, *paths);
        const PathLight along = state_->lightAlong(block, ray, light, angle);
        std::ranges::copy(along.radiance, values.begin());
        if (ray.end != RayPath::End::ground)
            return;
        // The ground is Lambertian: what leaves it, emitted and reflected, is the upward flux.
        const auto thermal = block.light.thermal();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double leaving = thermal->up[i] + (light ? light->fluxes.up[i] : 0.0);
            values[i] += along.transmittance[i] * leaving * std::numbers::inv_pi;
        }
    });
}

std::vector<double> RadiativeTransfer::solarIrradiance(const NodeSet& set, double altitude_m,
                                                       const SunPosition& sun) const {
    const RayPath ray = state_->tracer.towardsSun(altitude_m, sun.elevation_rad);
    if (ray.end != RayPath::End::space)
        return std::vector<double>(set.nodes.size(), 0.0);
    const std::vector<double> weights = levelWeights(ray, state_->column.levelCount());
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        opticalDepth(block.column, weights, Depth::extinction, values);
        turnToTransmittance(values);
        std::ranges::transform(values, block.column.sun(), values.begin(), std::multiplies());
    });
}

std::vector<double> RadiativeTransfer::upwardFlux(const NodeSet& set, double altitude_m,
                                                  const SunPosition& sun) const {
    const auto paths = state_->sunPaths(sun.elevation_rad);
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
    const auto paths = state_->sunPaths(sun.elevation_rad);
    return state_->forEachBlock(set, [&](const Block& block, std::span<double> values) {
        interpolateLevels(state_->column, block.light.thermal()->down, altitude_m, values);
        const auto light = state_->sunlight(block, *paths);
        if (!light)
            return;
        // Light scattered nearly forward is diffuse here, although the solution has it in the beam.
        std::vector<double> solar = light->fluxes.down;
        for (std::size_t i = 0; i < solar.size(); ++i)
            solar[i] += paths->sinElevation() * (light->scaled[i] - light->direct[i]);
        std::vector<double> here(values.size());
        interpolateLevels(state_->column, solar, altitude_m, here);
        std::ranges::transform(values, here, values.begin(), std::plus());
    });
}

} // namespace irsg
