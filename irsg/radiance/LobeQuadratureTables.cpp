#include "irsg/radiance/LobeQuadratureTables.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

namespace {

/// Nodes a roughness, along a quarter of a circle, and the least and the most of them.
constexpr double nodesPerRoughness = 3.2;
constexpr double fewestDivisions = 8.0, mostDivisions = 64.0;

/// Octants by the signs of coordinates, of which 0 counts as positive.
std::uint32_t octantOf(bool isXNegative, bool isYNegative, bool isZNegative) {
    return (isXNegative ? 1u : 0u) | (isYNegative ? 2u : 0u) | (isZNegative ? 4u : 0u);
}

} // namespace

LobeQuadratureTable::ViewCell LobeQuadratureTable::cellOf(const Vec3& view, bool byAzimuth) {
    const auto cell = [](double angle_rad) {
        return static_cast<int>(std::lround(angle_rad / cell_rad));
    };
    return {cell(std::asin(std::clamp(view.z, -1.0, 1.0))),
            byAzimuth ? cell(std::atan2(view.y, view.x)) : 0};
}

std::uint32_t LobeQuadratureTable::divisionsOf(const SurfaceModel& model) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(nodesPerRoughness / model.roughness()),
                                                 fewestDivisions, mostDivisions));
}

LobeQuadratureTable::LobeQuadratureTable(std::shared_ptr<const SurfaceModel> model,
                                         const SpecularEnvironmentGrid& grid, ViewCell cell)
    : model_(std::move(model)), grid_(grid), divisions_(divisionsOf(*model_)) {
    while (components < model_->components() && model_->hasLobe(components))
        ++components;
    places = grid_.places().size();
    const double elevation_rad = std::clamp(cell.elevation * cell_rad, -0.5 * pi, 0.5 * pi);
    const double azimuth_rad = cell.azimuth * cell_rad;
    view_ = {std::cos(elevation_rad) * std::cos(azimuth_rad),
             std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
    for (const SurfaceDirection& facet : model_->facets()) {
        facets_.push_back(facet);
        facets_.push_back({facet.x, -facet.y, facet.z});
    }
    const std::size_t edge = divisions_ + 1;
    numbers_.assign(8 * edge * edge, -1);
}

LobeQuadratureTable::About LobeQuadratureTable::about(const Vec3& mirror, std::uint32_t divisions) {
    const double n = divisions, x = std::abs(mirror.x), y = std::abs(mirror.y);
    const double scale = n / (x + y + std::abs(mirror.z));
    const double a = std::min(x * scale, n), b = std::min(y * scale, n - a);
    const auto i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b);
    const double alongA = a - i, alongB = b - j;
    About found;
    const auto put = [&](std::size_t corner, std::uint32_t ofA, std::uint32_t ofB, double weight) {
        if (!(weight > 0.0) || ofA + ofB > divisions) {
            // Rounding at an edge: the corner beside it has all of it.
            ofA = std::min(ofA, divisions);
            ofB = std::min(ofB, divisions - ofA);
            weight = std::max(weight, 0.0);
        }
        const std::uint32_t octant = octantOf(mirror.x < 0.0 && ofA > 0, mirror.y < 0.0 && ofB > 0,
                                              mirror.z < 0.0 && ofA + ofB < divisions);
        found.keys[corner] = (octant * (divisions + 1) + ofA) * (divisions + 1) + ofB;
        found.weights[corner] = static_cast<float>(weight);
    };
    if (alongA + alongB <= 1.0) {
        put(0, i, j, 1.0 - alongA - alongB);
        put(1, i + 1, j, alongA);
        put(2, i, j + 1, alongB);
    } else {
        put(0, i + 1, j + 1, alongA + alongB - 1.0);
        put(1, i, j + 1, 1.0 - alongA);
        put(2, i + 1, j, 1.0 - alongB);
    }
    return found;
}

Vec3 LobeQuadratureTable::directionOf(std::uint32_t key) const {
    const std::uint32_t edge = divisions_ + 1;
    const std::uint32_t octant = key / (edge * edge), a = key / edge % edge, b = key % edge;
    const Vec3 corner{(octant & 1u ? -1.0 : 1.0) * a, (octant & 2u ? -1.0 : 1.0) * b,
                      (octant & 4u ? -1.0 : 1.0) * (divisions_ - a - b)};
    return normalized(corner);
}

std::uint32_t LobeQuadratureTable::nodeOf(std::uint32_t key) {
    std::int32_t& number = numbers_[key];
    if (number < 0) {
        number = static_cast<std::int32_t>(keys.size());
        keys.push_back(key);
    }
    return static_cast<std::uint32_t>(number);
}

void LobeQuadratureTable::fill() {
    if (filled_ == keys.size())
        return;
    shares.resize(keys.size() * valuesOfNode(), 0.0f);
    constexpr std::size_t atOnce = 16;
    const std::size_t first = std::exchange(filled_, keys.size()), count = filled_ - first;
    parallelFor((count + atOnce - 1) / atOnce, [&](std::size_t some) {
        const std::size_t last = std::min(first + (some + 1) * atOnce, filled_);
        for (std::size_t node = first + some * atOnce; node < last; ++node)
            fillNode(node);
    });
}

void LobeQuadratureTable::fillNode(std::size_t node) {
    const Vec3 mirror = directionOf(keys[node]);
    const auto placesOf = [&](const Vec3& from) {
        const double level = std::hypot(from.x, from.y);
        const double fromSun_rad =
            level > 1e-9 ? std::acos(std::clamp(from.x / level, -1.0, 1.0)) : 0.0;
        return grid_.about(std::asin(std::clamp(from.z, -1.0, 1.0)), fromSun_rad);
    };

    // The surface that mirrors there, and its axes: the normal, and one in the plane of view.
    const Vec3 sum = view_ + mirror;
    const double size = plainLength(sum);
    std::vector<double> weights(valuesOfNode(), 0.0);
    std::array<double, SurfaceModel::mostComponents> sums{};
    if (size > 1e-6) {
        const Vec3 normal = sum * (1.0 / size);
        const SurfaceDirection to{std::sqrt(std::max(1.0 - 0.25 * size * size, 0.0)), 0.0,
                                  std::max(0.5 * size, 1e-4)};
        Vec3 x = view_ - normal * product(normal, view_);
        if (plainLength(x) > 1e-9)
            x = normalized(x);
        else
            x = normalized(cross(std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, normal));
        const Vec3 y = crossed(normal, x);
        for (const SurfaceDirection& facet : facets_) {
            const SurfaceModel::Amounts sent = model_->facetWeights(to, facet);
            const SurfaceDirection from = irsg::mirrored(to, facet);
            const auto all = placesOf(x * from.x + y * from.y + normal * from.z);
            for (std::size_t k = 0; k < components; ++k) {
                sums[k] += sent[k];
                for (const auto& [place, part] : all)
                    weights[k * places + place] += sent[k] * part;
            }
        }
    }
    for (std::size_t k = 0; k < components; ++k) {
        float* own = &shares[node * valuesOfNode() + k * places];
        if (!(sums[k] > 0.0)) // no facet that stands for others faces the eye
            for (const auto& [place, part] : placesOf(mirror))
                own[place] += static_cast<float>(part);
        for (std::size_t place = 0; sums[k] > 0.0 && place < places; ++place)
            own[place] = static_cast<float>(weights[k * places + place] / sums[k]);
    }
}

std::shared_ptr<LobeQuadratureTable>
LobeQuadratureTables::of(const std::shared_ptr<const SurfaceModel>& model,
                         const SpecularEnvironmentGrid& grid, LobeQuadratureTable::ViewCell cell) {
    const Key key{model.get(), grid.key(), cell};
    if (const auto known = tables_.find(key); known != tables_.end())
        return known->second;
    std::size_t nodes = 0;
    for (const auto& [each, table] : tables_)
        nodes += table->nodes();
    if (nodes > mostNodes)
        tables_.clear();
    return tables_[key] = std::make_shared<LobeQuadratureTable>(model, grid, cell);
}

} // namespace irsg
