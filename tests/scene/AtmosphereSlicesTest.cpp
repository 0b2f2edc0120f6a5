// Strong air in one of several bands cuts an object finely; the others take as few of its slices as
// their own air needs, and what they have between them is linear.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/exchange/LightIntegrals.h"
#include "irsg/radiometry/DotProducts.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const Band weakBand = Band::topHat(3.0, 4.0), strongBand = Band::topHat(4.2, 4.4);
const double weak_per_m = 5e-3, strong_per_m = 0.1;
/// Of what arrives, where the air changes by 0.0632 from node to node.
constexpr double boundOfSlices = 5.1e-4;

/// Air that takes much in one band and little in the others, and shines.
Environment atmosphereWithABand() {
    BeerLambertParameters parameters;
    parameters.extinction_per_m =
        Spectrum({2.0, 4.1, 4.15, 4.45, 4.5, 6.0},
                 {weak_per_m, weak_per_m, strong_per_m, strong_per_m, weak_per_m, weak_per_m});
    parameters.airTemperature_K = parameters.groundTemperature_K = 280.0;
    Environment environment;
    environment.add(std::make_shared<BeerLambert>(parameters));
    return environment;
}

/// Two walls, one 6 m behind the other and beside it.
Entity twoWalls() {
    const IrCodes codes{1, 1};
    Entity entity = entityOf(modelOf(joined(plateMesh({-5, 3, 0}, {5, 0, 0}, {0, 0, -5}, codes),
                                            plateMesh({5, -3, 0}, {5, 0, 0}, {0, 0, -5}, codes))),
                             greyDatabase(0.6, 500.0));
    entity.referencePoint_m = Vec3{};
    return entity;
}

/// The walls' air in both bands, and what surfaces send in it.
struct SlicedWalls {
    std::vector<Entity> entities{twoWalls()};
    RenderSettings settings = RenderSettings::direct();
    AtmosphericQueryCache answers;
    SceneSampling sampling;
    SampledScenes scenes;
    std::vector<ObjectGeometry> geometry{1};
    std::shared_ptr<const SampledScene> sampled;
    std::unique_ptr<SceneRadiometry> radiometry;

    explicit SlicedWalls(const std::vector<Band>& bands) {
        answers.setEnvironment(atmosphereWithABand());
        geometry[0].path = {standingAltitude_m, standingAltitude_m, 40.0, 0.0};
        geometry[0].nearest_m = 35.0;
        geometry[0].farthest_m = 45.0;
        sampled = scenes.of(
            answers, {RadianceTerms::standard(), entities, geometry, settings, LineOfSight{}},
            bands, false, [&](const AtmosphereScene& scene, const std::vector<Band>& all) {
                return sampling.spectral(answers, scene, all);
            });
        geometry[0].slices_m = sampled->slices_m[0];
        radiometry = std::make_unique<SceneRadiometry>(RadianceTerms::standard(), entities,
                                                       geometry, sampled->bands);
    }
};

} // namespace

TEST(SliceBetween, HoldsTheNodesThatAreTakenAboutANode) {
    const auto expect = [](const SliceBetween& about, int below, int above, double part) {
        EXPECT_EQ(about.below, below);
        EXPECT_EQ(about.above, above);
        EXPECT_DOUBLE_EQ(about.part, part);
    };
    expect(sliceBetween(3, 1, 9), 3, 3, 0.0);
    expect(sliceBetween(4, 4, 10), 4, 4, 0.0);
    expect(sliceBetween(5, 4, 10), 4, 8, 0.25);
    expect(sliceBetween(9, 4, 10), 8, 10, 0.5); // the last stretch is shorter
    expect(sliceBetween(10, 4, 10), 10, 10, 0.0);
    expect(sliceBetween(1, 64, 3), 0, 3, 1.0 / 3.0);
}

TEST(SlicesOfBands, AreTakenAsFinelyAsEachBandNeeds) {
    const SlicedWalls walls({weakBand, strongBand});
    const std::vector<SampledBand>& bands = walls.sampled->bands;
    ASSERT_EQ(bands.size(), 2u);
    const int slices = static_cast<int>(walls.geometry[0].slices_m.size()) - 1;
    EXPECT_GE(slices, 15) << "1 of optical depth in steps of 0.0632";
    EXPECT_EQ(bands[1].sliceStep(0, 0), 1);
    EXPECT_EQ(bands[0].sliceStep(0, 0), slices) << "0.05 of optical depth in one";
    EXPECT_LT(walls.sampled->atmosphereError[0], boundOfSlices);

    // Linear between the ends in the one band, in the other what the air says.
    const std::vector<AtmosphereSamples>& nodes = bands[0].air.objects[0].nodes;
    const std::vector<AtmosphereSamples>& asked = bands[1].air.objects[0].nodes;
    ASSERT_EQ(nodes.size(), asked.size());
    const double part = 3.0 / slices;
    const std::size_t path = 4;
    ASSERT_EQ(RadianceTerms::standard().terms[path].name, "path");
    for (std::size_t i = 0; i < bands[0].sampling->size(); ++i) {
        const auto between = [&](const auto& of) {
            EXPECT_NEAR(of(nodes[3]) / ((1.0 - part) * of(nodes.front()) + part * of(nodes.back())),
                        1.0, 1e-14);
        };
        between([i](const AtmosphereSamples& node) { return (*node.transmittance)[i]; });
        between([&](const AtmosphereSamples& node) { return (*node.light[path])[i]; });
    }
    EXPECT_NEAR((*asked[3].transmittance)[0],
                std::exp(-strong_per_m * walls.geometry[0].slices_m[3]), 1e-12);
    // Light onto the object is that of its reference point at every node.
    EXPECT_EQ(nodes[3].light[3], nodes[0].light[3]);
}

TEST(SlicesOfBands, GiveWhatEachBandGivesAlone) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = atmosphereWithABand();
    irsg.scene.entities = {twoWalls()};
    look(irsg, {.range_m = 40.0, .fieldOfView_rad = 0.2});
    const std::vector<Band> bands{weakBand, strongBand, Band::topHat(4.6, 5.0)};
    const std::vector<RenderReport> together = irsg.measure(bands);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const double alone = irsg.measure({bands[i]}).front().all.intensity_W_sr;
        EXPECT_NEAR(together[i].all.intensity_W_sr / alone, 1.0, i == 1 ? 1e-12 : boundOfSlices)
            << i;
    }
}

// Sums over nodes are skipped where they follow from others: they are what they would be.
TEST(SlicesOfBands, SumUpToWhatTheirAirSays) {
    const SlicedWalls walls({weakBand, strongBand});
    const SceneRadiometry& radiometry = *walls.radiometry;
    OccluderStacks occluderStacks;
    SurfaceRadianceTable radiances(radiometry, occluderStacks);
    for (int row = 0; row < radiometry.rows().size(); ++row) {
        const SurfaceStackId kind{0, row};
        radiances.prepare({kind});
        for (std::size_t output = 0; output < 2; ++output) {
            // Factors of 1: view, sky and sun; nothing is left for the ground.
            const SurfaceStackRadiance found = radiances.of(kind, output);
            double sent = found.constant;
            for (const double perFactor : found.perFactor) {
                sent += perFactor;
            }
            const std::vector<double> terms = radiances.terms(kind, output);
            double expected = 0.0;
            for (std::size_t k = 0; k < terms.size(); ++k) {
                if (RadianceTerms::standard().terms[k].name != "up") {
                    expected += terms[k];
                }
            }
            EXPECT_NEAR(sent / expected, 1.0, 1e-12) << row << ' ' << output;
        }
    }
}

TEST(SlicesOfBands, SumUpLightBetweenSurfacesToWhatTheirAirSays) {
    const SlicedWalls walls({weakBand, strongBand});
    const SceneRadiometry& radiometry = *walls.radiometry;
    const std::size_t nodes = radiometry.weights_um().size();
    OccluderStacks occluderStacks;
    LightKnots knots;
    knots.count = 2;
    std::vector<std::vector<double>> sources(1, std::vector<double>(nodes));
    for (std::size_t i = 0; i < nodes; ++i) {
        knots.between.push_back({0, 1});
        knots.parts.push_back(0.25);
        sources[0][i] = 1.0 + static_cast<double>(i % 7);
    }
    // In place of the ground's light, of which this air has none: that of the first row.
    const std::size_t light = 4;
    const LightIntegrals integrals(radiometry, occluderStacks, knots, sources, -1, light);
    const std::vector<double>& taken_W_m2_um = *radiometry.air(0).light[light];
    std::vector<SurfaceStackId> kinds;
    kinds.reserve(static_cast<std::size_t>(radiometry.rows().size()));
    for (int row = 0; row < radiometry.rows().size(); ++row) {
        kinds.push_back({0, row});
    }
    const auto all = integrals.ofAll(kinds);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        for (std::size_t output = 0; output < 2; ++output) {
            const auto& [first, last] = radiometry.outputs()[output];
            const AtmosphereSamples& air = radiometry.air(kinds[k].row);
            double given = 0.0, taken = 0.0;
            for (std::size_t i = first; i < last; ++i) {
                const double reflected = radiometry.weights_um()[i] *
                                         radiometry.surface(kinds[k].row).reflectance[i] *
                                         (*air.transmittance)[i];
                given += reflected * sources[0][i];
                taken += reflected * taken_W_m2_um[i];
            }
            ASSERT_EQ(all[k][output].size(), integrals.width());
            EXPECT_EQ(all[k][output][0], 0.0) << "no sky";
            EXPECT_NEAR(all[k][output][1] / -taken, 1.0, 1e-12) << k << ' ' << output;
            EXPECT_NEAR(all[k][output][2] / (0.75 * given), 1.0, 1e-12) << k << ' ' << output;
            EXPECT_NEAR(all[k][output][3] / (0.25 * given), 1.0, 1e-12) << k << ' ' << output;
            EXPECT_EQ(all[k][output], integrals.of(kinds[k], output))
                << "alone or together, to the last digit";
        }
    }
}
