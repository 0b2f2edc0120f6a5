// Tables of where lobes lie against sums over their facets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <vector>

#include "irsg/radiance/LobeQuadratureTables.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RayVectors.h"
#include "irsg/signature/FacetAlbedos.h"
#include "irsg/signature/SurfaceModels.h"

using namespace irsg;

namespace {

/// A model with the amounts of its components.
struct Surface {
    std::shared_ptr<const SurfaceModel> model;
    SurfaceModel::Amounts amounts{};

    /// What of component k is seen of all lobes at a cosine.
    double part(std::size_t k, double cosine) const {
        double all = 0.0;
        for (std::size_t i = 0; i < model->components() && model->hasLobe(i); ++i) {
            all += amounts[i] * model->albedo(i, cosine);
        }
        return amounts[k] * model->albedo(k, cosine) / all;
    }
};

Surface surfaceOf(const char* name, double roughness) {
    Material material;
    material.surfaceModel = name;
    material.roughness = roughness;
    material.emissivity = Spectrum::constant(0.3);
    if (material.surfaceModel == "shellTarget") {
        material.refractiveIndex = Spectrum::constant(2.0);
        material.extinction = Spectrum::constant(3.0);
    }
    const auto model = surfaceModelOf(material);
    return {model, model->amountsAt(material, 4.0)};
}

/// A sky that is bright at the horizon and about the sun's azimuth, over ground.
std::vector<double> radiances(const SpecularEnvironmentGrid& grid, double horizon_rad) {
    std::vector<double> all;
    for (const SpecularEnvironmentGrid::Direction& place : grid.places()) {
        const double above_rad = place.elevation_rad - horizon_rad;
        const double sky = 0.4 + 0.5 * std::exp(-std::max(above_rad, 0.0) / 0.2) +
                           (grid.isByAzimuth() ? 0.1 * std::exp(-place.fromSun_rad) : 0.0);
        all.push_back(above_rad > 0.0 ? sky : 0.8);
    }
    return all;
}

/// Equal on every machine, in [0, 1).
struct Draws {
    std::uint64_t state = 7;
    double next() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) / 9007199254740992.0;
    }
    Vec3 direction() {
        const double z = 2.0 * next() - 1.0, angle = 2.0 * pi * next();
        const double level = std::sqrt(1.0 - z * z);
        return {level * std::cos(angle), level * std::sin(angle), z};
    }
};

/// A surface and who looks at it, in axes with z up and x towards the sun's azimuth.
struct Case {
    Vec3 normal, view;
};

/// What is seen mirrored, as a mean over all lobes: by facets in rings.
double exactly(const Surface& surface, double roughness, FacetDistribution distribution,
               const SpecularEnvironmentGrid& grid, const std::vector<double>& lights,
               const Case& of) {
    const double cosine = product(of.normal, of.view);
    const Vec3 x = normalized(of.view - of.normal * cosine), y = crossed(of.normal, x);
    double sum = 0.0, weights = 0.0;
    overFacets(Microfacets(distribution, roughness), cosine,
               [&](const SurfaceDirection& to, const SurfaceDirection& half, double area) {
                   for (const double side : {-1.0, 1.0}) {
                       const SurfaceDirection facet{half.x, side * half.y, half.z};
                       const SurfaceModel::Amounts sent = surface.model->facetWeights(to, facet);
                       const double weight =
                           area * std::inner_product(sent.begin(), sent.end(),
                                                     surface.amounts.begin(), 0.0);
                       const SurfaceDirection from = mirrored(to, facet);
                       const Vec3 w = x * from.x + y * from.y + of.normal * from.z;
                       double light = 0.0;
                       for (const auto& [place, part] : grid.about(
                                std::asin(std::clamp(w.z, -1.0, 1.0)),
                                std::acos(std::clamp(w.x / std::hypot(w.x, w.y), -1.0, 1.0)))) {
                           light += part * lights[place];
                       }
                       sum += weight * light;
                       weights += weight;
                   }
               });
    return sum / weights;
}

/// The same by the facets that stand for all, for each sample anew.
double byFacets(const Surface& surface, const SpecularEnvironmentGrid& grid,
                const std::vector<double>& lights, const Case& of) {
    const double cosine = product(of.normal, of.view);
    const Vec3 x = normalized(of.view - of.normal * cosine), y = crossed(of.normal, x);
    const SurfaceDirection to{std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    SurfaceModel::Amounts sums{}, weights{};
    for (const SurfaceDirection& facet : surface.model->facets()) {
        const SurfaceModel::Amounts sent = surface.model->facetWeights(to, facet);
        const SurfaceDirection from = mirrored(to, facet);
        const Vec3 w = x * from.x + y * from.y + of.normal * from.z;
        double light = 0.0;
        for (const auto& [place, part] :
             grid.about(std::asin(std::clamp(w.z, -1.0, 1.0)),
                        std::acos(std::clamp(w.x / std::hypot(w.x, w.y), -1.0, 1.0)))) {
            light += part * lights[place];
        }
        for (std::size_t k = 0; k < sent.size(); ++k) {
            sums[k] += sent[k] * light;
            weights[k] += sent[k];
        }
    }
    double all = 0.0, parts = 0.0;
    for (std::size_t k = 0; k < surface.model->components() && surface.model->hasLobe(k); ++k) {
        if (weights[k] > 0.0) {
            all += surface.part(k, cosine) * sums[k] / weights[k];
            parts += surface.part(k, cosine);
        }
    }
    return all / parts;
}

double byTable(const Surface& surface, const SpecularEnvironmentGrid& grid,
               const std::vector<double>& lights, LobeQuadratureTables& tables, const Case& of) {
    const Vec3 x = grid.isByAzimuth() ? Vec3{1, 0, 0} : normalized({of.view.x, of.view.y, 0.0});
    const Vec3 z{0, 0, 1}, y = crossed(z, x);
    const auto inTable = [&](const Vec3& v) { return Vec3{product(v, x), product(v, y), v.z}; };
    const Vec3 mirror = of.normal * (2.0 * product(of.normal, of.view)) - of.view;
    const auto table = tables.of(surface.model, grid,
                                 LobeQuadratureTable::cellOf(inTable(of.view), grid.isByAzimuth()));
    const LobeQuadratureTable::About about = LobeQuadratureTable::about(
        inTable(mirror), LobeQuadratureTable::divisionsOf(*surface.model));
    const double cosine = product(of.normal, of.view);
    double sum = 0.0, weights = 0.0;
    for (std::size_t n = 0; n < 3; ++n) {
        const std::uint32_t node = table->nodeOf(about.keys[n]);
        table->fill();
        weights += static_cast<double>(about.weights[n]);
        for (std::size_t k = 0; k < table->components; ++k) {
            double light = 0.0, shares = 0.0;
            for (std::size_t place = 0; place < lights.size(); ++place) {
                const auto share = static_cast<double>(table->of(node)[k * table->places + place]);
                light += share * lights[place];
                shares += share;
            }
            EXPECT_NEAR(shares, 1.0, 1e-5);
            sum += static_cast<double>(about.weights[n]) * surface.part(k, cosine) * light;
        }
    }
    EXPECT_NEAR(weights, 1.0, 1e-6);
    return sum;
}

} // namespace

TEST(LobeQuadratureTablesTest, AgreeWithTheIntegralOverFacets) {
    constexpr double horizon_rad = -0.02;
    struct Row {
        const char* name;
        FacetDistribution distribution;
    };
    for (const Row& row :
         {Row{"ggx", FacetDistribution::ggx}, Row{"beckmann", FacetDistribution::beckmann},
          Row{"shellTarget", FacetDistribution::beckmann}}) {
        for (const double roughness : {0.05, 0.1, 0.2, 0.5}) {
            for (const bool byAzimuth : {false, true}) {
                const SpecularEnvironmentGrid grid(horizon_rad, byAzimuth);
                const std::vector<double> lights = radiances(grid, horizon_rad);
                const Surface surface = surfaceOf(row.name, roughness);
                LobeQuadratureTables tables;
                Draws draws;
                double squares = 0.0, worst = 0.0, squaresOfFacets = 0.0;
                int count = 0;
                while (count < 300) {
                    const Case one{draws.direction(), draws.direction()};
                    if (product(one.normal, one.view) < 0.1) {
                        continue;
                    }
                    ++count;
                    const double exact =
                        exactly(surface, roughness, row.distribution, grid, lights, one);
                    const double off = byTable(surface, grid, lights, tables, one) / exact - 1.0;
                    squares += off * off;
                    const double facets = byFacets(surface, grid, lights, one) / exact - 1.0;
                    squaresOfFacets += facets * facets;
                    worst = std::max(worst, std::abs(off));
                }
                const double rms = std::sqrt(squares / count);
                const double ofFacets = std::sqrt(squaresOfFacets / count);
                std::printf("  %-12s %4.2f %-10s rms %.2f %%, worst %.2f %%; facet by facet rms "
                            "%.2f %%\n",
                            row.name, roughness, byAzimuth ? "by azimuth" : "", 100.0 * rms,
                            100.0 * worst, 100.0 * ofFacets);
                EXPECT_LE(rms, 0.022) << row.name << " " << roughness;
                EXPECT_LE(worst, 0.11) << row.name << " " << roughness;
                // Not worse than what they stand for.
                EXPECT_LE(rms, std::max(1.05 * ofFacets, 0.005)) << row.name << " " << roughness;
            }
        }
    }
}

TEST(LobeQuadratureTablesTest, NodesOfAllOctantsMeetAtTheirEdges) {
    const std::uint32_t divisions = 9;
    for (const Vec3& at : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
        double weight = 0.0;
        const LobeQuadratureTable::About about = LobeQuadratureTable::about(at, divisions);
        for (std::size_t n = 0; n < 3; ++n) {
            weight = std::max(weight, static_cast<double>(about.weights[n]));
        }
        EXPECT_NEAR(weight, 1.0, 1e-6);
    }
    // On either side of an edge the same nodes count alike.
    const auto valueAt = [&](const Vec3& at) {
        const LobeQuadratureTable::About about =
            LobeQuadratureTable::about(normalized(at), divisions);
        double sum = 0.0;
        for (std::size_t n = 0; n < 3; ++n) {
            sum += static_cast<double>(about.weights[n]) *
                   std::sin(static_cast<double>(about.keys[n]));
        }
        return sum;
    };
    Draws draws;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 at = draws.direction();
        constexpr double beside = 1e-7;
        EXPECT_NEAR(valueAt({at.x, at.y, beside}), valueAt({at.x, at.y, -beside}), 1e-4);
        EXPECT_NEAR(valueAt({at.x, beside, at.z}), valueAt({at.x, -beside, at.z}), 1e-4);
        EXPECT_NEAR(valueAt({beside, at.y, at.z}), valueAt({-beside, at.y, at.z}), 1e-4);
    }
}
