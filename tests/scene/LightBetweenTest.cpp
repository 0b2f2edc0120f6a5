// Light between surfaces by every way through the renderer, and isothermal enclosures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/random/Philox.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class LightBetweenTest : public RaysTest {};

/// Six walls and a ball inside, of six materials, grey and spectral, all of 400 K.
Entity furnace(bool isBlack) {
    Triangles mesh =
        reversed(boxMesh({2, 1.5, 1}, {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 5}, {1, 6}}));
    mesh = joined(mesh, sphereMesh(0.5, 6, 10, {1, 7}));
    SignatureDatabase database = greyDatabase(0.9, 400.0);
    const auto spectral = [](double a, double b, double c) {
        Material material;
        material.emissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {a, b, c, a});
        return material;
    };
    database.materials[2] = greyMaterial(0.5);
    database.materials[3] = greyMaterial(0.1);
    database.materials[4] = spectral(0.2, 0.9, 0.3);
    database.materials[5] = spectral(0.7, 0.1, 0.6);
    database.materials[6] = spectral(0.4, 0.4, 0.95);
    database.materials[7] = spectral(0.05, 0.6, 0.2);
    if (isBlack) {
        for (int m = 1; m <= 7; ++m) {
            database.materials[m] = greyMaterial(1.0);
        }
    }
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    entity.referencePoint_m = Vec3{};
    return entity;
}

} // namespace

TEST_F(LightBetweenTest, TellsItsStagesWithTheirShares) {
    std::map<std::string, double> largest; // shares by stage
    std::string last = "none";
    const StageListener listener([&](std::string_view stage, std::optional<double> share) {
        last = stage;
        double& own = largest[last];
        own = std::max(own, share.value_or(0.0));
    });
    pixelsInRoom(furnace(false), convergedBounces, 0.0053); // which no other test asks for
    for (const char* part : {"view factors, round 1", "balance", "pairs", "bounces"}) {
        EXPECT_GT(largest[std::string("inter-reflection: ") + part], 0.0) << part;
    }
    EXPECT_EQ(last, "");
}

TEST_F(LightBetweenTest, AnIsothermalEnclosureIsBlack) {
    for (const auto& [error, most] : {std::pair{0.005, 1e-3}, std::pair{0.002, 1e-4}}) {
        const std::vector<double> black = pixelsInRoom(furnace(true), 0, error);
        const auto [least, greatest] =
            ratiosOf(pixelsInRoom(furnace(false), convergedBounces, error), black);
        const double direct = ratiosOf(pixelsInRoom(furnace(false), 0, error), black).first;
        std::printf("  lightError %g: pixels %.2e to %.2e off, %.3f without inter-reflection\n",
                    error, least - 1.0, greatest - 1.0, direct);
        EXPECT_GE(least, 1.0 - most);
        EXPECT_LE(greatest, 1.0 + most);
        EXPECT_LE(direct, 0.5);
    }
}

namespace {

/// A sunlit floor with two walls, a step and a ball, in bright air.
Entity corner(double wallEmissivity = 0.3) {
    Triangles mesh = joined(plateMesh({}, {2, 0, 0}, {0, 2, 0}, {1, 1}),
                            plateMesh({0, 2, 1}, {0, 0, 1}, {2, 0, 0}, {2, 2}));
    mesh = joined(mesh, plateMesh({-2, 0, 1}, {0, 2, 0}, {0, 0, 1}, {3, 1}));
    Triangles ball = sphereMesh(0.4, 24, 48, {2, 3});
    for (Triangle& t : ball) {
        for (Vec3& v : t.vertex) {
            v = v + Vec3{0.3, -0.2, 0.6};
        }
    }
    mesh = joined(mesh, ball);
    SignatureDatabase database = greyDatabase(0.4, 300.0);
    database.temperatures[2] = fixedTemperature(420.0);
    database.temperatures[3] = fixedTemperature(330.0);
    database.materials[2] = greyMaterial(wallEmissivity);
    database.materials[3].emissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {0.2, 0.7, 0.3, 0.3});
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    return entity;
}

RenderSettings brightSettings(EngineChoice engine, int bounces) {
    RenderSettings settings = RenderSettings::direct();
    settings.engine = engine;
    settings.bounces = bounces;
    settings.sunShadows = SunShadowMode::point;
    return settings;
}

} // namespace

TEST_F(LightBetweenTest, EveryWayGivesTheSame) {
    for (const EngineChoice engine : {EngineChoice::opengl, EngineChoice::rays}) {
        for (const int bounces : {1, convergedBounces}) {
            InteractiveRenderer irsg =
                rendererOf({corner()}, brightSettings(engine, bounces), brightAtmosphere());
            View view;
            view.azimuth_rad = 2.2;
            view.elevation_rad = 0.7;
            view.fieldOfView_rad = 0.08;
            look(irsg, view);
            const RenderedImage picture = irsg.imageWithReport();
            const double seen = picture.report.all.intensity_W_sr;
            const double swept = irsg.measure().all.intensity_W_sr;
            EXPECT_NEAR(seen / swept, 1.0, 2e-3);
            // Both followed pictures: drawn, and as a sum of pixels.
            const RadianceImage drawn = irsg.picture(), summed = irsg.picture();
            for (std::size_t i = 0; i < drawn.find("L")->values.size(); ++i) {
                ASSERT_NEAR(drawn.find("L")->values[i], summed.find("L")->values[i],
                            2e-5f * std::abs(drawn.find("L")->values[i]) + 1e-6f);
            }
            // A spectrum adds up to the band, with bins of a top hat.
            std::vector<double> wavenumbers;
            for (int i = 0; i < 400; ++i) {
                wavenumbers.push_back(1e4 / (3.0 + 2.0 * (i + 0.5) / 400));
            }
            const IntensitySpectrum spectrum = irsg.measureSpectrum(wavenumbers);
            double sum = 0.0;
            for (const double value : spectrum.intensity_W_sr_um) {
                sum += value * 2.0 / 400;
            }
            EXPECT_NEAR(sum / swept, 1.0, 1e-3);
            // A view as a function of scales.
            const std::vector<ScalingInput> inputs{{0, ScalingKind::temperature, 2, 0.9, 1.1},
                                                   {0, ScalingKind::emissivity, 2, 0.8, 1.2}};
            const auto scaled = irsg.scaledView(inputs);
            ScaledValues values;
            for (const std::array<double, 2>& scales :
                 {std::array{1.0, 1.0}, std::array{1.07, 1.0}, std::array{0.95, 1.1}}) {
                scaled->evaluate(scales, values);
                Entity other = corner();
                other.temperatureScale[2] = scales[0];
                other.emissivityScale[2] = scales[1];
                InteractiveRenderer there =
                    rendererOf({other}, irsg.scene.settings, brightAtmosphere());
                look(there, view);
                const double expected = there.measure().all.intensity_W_sr;
                // What is reflected on the way counts to the first order.
                EXPECT_NEAR(values.intensity[0] / expected, 1.0, scales[1] == 1.0 ? 1e-4 : 5e-4)
                    << scales[0];
            }
            // Nothing gets lost among several bands.
            const auto bands = irsg.measure({Band::topHat(3.0, 5.0), Band::topHat(4.2, 4.5)});
            EXPECT_NEAR(bands[0].all.intensity_W_sr / swept, 1.0, 1e-9);

            RenderSettings truth = irsg.scene.settings;
            truth.truthLayers = true;
            irsg.scene.settings = truth;
            const RadianceImage layers = irsg.imageWithReport().image;
            const std::vector<float>& whole = layers.find("L")->values;
            double others = 0.0;
            for (std::size_t i = 0; i < whole.size(); ++i) {
                double parts = 0.0;
                for (const char* name :
                     {"thermal", "sun", "up", "down", "path", "inter_reflection", "background"}) {
                    parts += static_cast<double>(layers.find(name)->values[i]);
                }
                others += static_cast<double>(layers.find("inter_reflection")->values[i]);
                EXPECT_NEAR(parts, static_cast<double>(whole[i]), 2e-5 * std::abs(parts) + 1e-6);
                EXPECT_LE(layers.find("sky_visibility")->values[i], 1.0001f);
            }
            EXPECT_GT(others, 0.0);
        }
    }
}

namespace {

/// A box without its lid, of three materials and a ball of a spectral one in it: light is reflected
/// many times before it leaves.
Entity openBox() {
    Triangles mesh =
        reversed(boxMesh({2, 1.5, 1}, {{1, 1}, {1, 1}, {2, 2}, {2, 2}, {3, 3}, {3, 3}}));
    std::erase_if(mesh, [](const Triangle& triangle) {
        return std::ranges::all_of(triangle.vertex, [](const Vec3& v) { return v.z > 0.999; });
    });
    mesh = joined(mesh, sphereMesh(0.5, 12, 24, {4, 4}));
    SignatureDatabase database = greyDatabase(0.6, 300.0);
    database.temperatures[2] = fixedTemperature(420.0);
    database.temperatures[3] = fixedTemperature(350.0);
    database.temperatures[4] = fixedTemperature(390.0);
    database.materials[2] = greyMaterial(0.3);
    database.materials[3] = greyMaterial(0.97);
    database.materials[4].emissivity = Spectrum({2.0, 3.5, 4.2, 6.0}, {0.2, 0.7, 0.3, 0.3});
    Entity entity = entityOf(modelOf(mesh), database);
    entity.pose.position_m.z = standingAltitude_m;
    return entity;
}

std::vector<ScalingInput> scalesOfBox(double off) {
    std::vector<ScalingInput> inputs;
    for (int index = 1; index <= 4; ++index) {
        inputs.push_back({0, ScalingKind::temperature, index, 1.0 - 0.5 * off, 1.0 + 0.5 * off});
        inputs.push_back({0, ScalingKind::emissivity, index, 1.0 - off, 1.0 + off});
    }
    return inputs;
}

/// The largest relative difference between draws of a view and scenes that are scaled by as much.
double worstDraw(const std::vector<ScalingInput>& inputs, bool isSpectrum) {
    const RenderSettings settings = brightSettings(EngineChoice::rays, convergedBounces);
    const View view{.azimuth_rad = 0.5, .elevation_rad = 0.9, .fieldOfView_rad = 0.08};
    const std::vector<double> wavenumbers_per_cm{2100.0, 2600.0, 3100.0};
    InteractiveRenderer irsg = rendererOf({openBox()}, settings, brightAtmosphere());
    look(irsg, view);
    const auto scaled =
        isSpectrum ? irsg.scaledSpectrum(inputs, wavenumbers_per_cm) : irsg.scaledView(inputs);
    double worst = 0.0;
    for (std::uint64_t number = 0; number < 6; ++number) {
        std::vector<double> scales;
        Entity box = openBox();
        for (const ScalingInput& input : inputs) {
            const double unit =
                unitOf(3, {static_cast<std::uint32_t>(input.kind), 0, input.index}, number);
            scales.push_back(input.least + (input.most - input.least) * unit);
            auto& scale =
                input.kind == ScalingKind::temperature ? box.temperatureScale : box.emissivityScale;
            scale[input.index] = scales.back();
        }
        ScaledValues found;
        scaled->evaluate(scales, found);
        InteractiveRenderer there = rendererOf({box}, settings, brightAtmosphere());
        look(there, view);
        std::vector<double> expected{there.measure().all.intensity_W_sr};
        if (isSpectrum) {
            expected = there.measureSpectrum(wavenumbers_per_cm).intensity_W_sr_um;
        }
        for (std::size_t i = 0; i < expected.size(); ++i) {
            worst = std::max(worst, std::abs(found.intensity[i] / expected[i] - 1.0));
        }
    }
    return worst;
}

} // namespace

TEST_F(LightBetweenTest, DrawsFollowLightThroughManyReflections) {
    // What is reflected on the way counts to the first order.
    EXPECT_LT(worstDraw(scalesOfBox(0.03), false), 2e-4);
    EXPECT_LT(worstDraw(scalesOfBox(0.1), false), 2e-3);
    EXPECT_LT(worstDraw(scalesOfBox(0.03), true), 2e-4);
}

TEST_F(LightBetweenTest, ThreadsChangeNoBit) {
    std::vector<float> first;
    for (const unsigned threads : {1u, 3u, 0u}) {
        setMostThreads(threads);
        InteractiveRenderer irsg = rendererOf(
            {corner()}, brightSettings(EngineChoice::rays, convergedBounces), brightAtmosphere());
        look(irsg, {.azimuth_rad = 2.2, .elevation_rad = 0.7, .fieldOfView_rad = 0.08});
        const RadianceImage image = irsg.imageWithReport().image;
        if (first.empty()) {
            first = image.find("L")->values;
        }
        EXPECT_EQ(image.find("L")->values, first);
    }
    setMostThreads(0);
}

TEST_F(LightBetweenTest, ConvexBodiesAreAsBefore) {
    Entity entity = entityOf(modelOf(sphereMesh(1.0, 40, 80, {1, 1})), greyDatabase(0.5, 300.0));
    entity.pose.position_m.z = standingAltitude_m;
    std::vector<std::vector<float>> images;
    for (const int bounces : {0, convergedBounces}) {
        InteractiveRenderer irsg =
            rendererOf({entity}, brightSettings(EngineChoice::rays, bounces), brightAtmosphere());
        look(irsg, {});
        images.push_back(irsg.imageWithReport().image.find("L")->values);
    }
    EXPECT_EQ(images[0], images[1]);
}

TEST_F(LightBetweenTest, OthersLightAsOwnPartsDo) {
    const Triangles floor = plateMesh({}, {2, 0, 0}, {0, 2, 0}, {1, 1});
    Triangles ball = sphereMesh(0.8, 32, 64, {2, 2});
    for (Triangle& t : ball) {
        for (Vec3& v : t.vertex) {
            v = v + Vec3{0, 0, 1.2};
        }
    }
    SignatureDatabase database = greyDatabase(0.3, 300.0);
    database.temperatures[2] = fixedTemperature(500.0);
    database.materials[2] = greyMaterial(0.8);
    std::array<double, 3> intensity{};
    for (int i = 0; i < 3; ++i) {
        std::vector<Entity> entities;
        if (i == 0) {
            entities.push_back(entityOf(modelOf(joined(floor, ball)), database));
        } else {
            entities = {entityOf(modelOf(floor), database), entityOf(modelOf(ball), database)};
        }
        for (Entity& entity : entities) {
            entity.pose.position_m = {3, -2, standingAltitude_m};
            entity.pose.attitude = {0.4, 0.2, -0.3};
            entity.referencePoint_m = Vec3{};
        }
        RenderSettings settings = brightSettings(EngineChoice::rays, i == 2 ? 0 : convergedBounces);
        settings.lightError = 0.004;
        InteractiveRenderer irsg = rendererOf(entities, settings, brightAtmosphere());
        look(irsg, {.azimuth_rad = 0.5, .elevation_rad = 0.9, .fieldOfView_rad = 0.1});
        intensity[static_cast<std::size_t>(i)] = irsg.measure().all.intensity_W_sr;
    }
    EXPECT_NEAR(intensity[1] / intensity[0], 1.0, 3e-3);
    EXPECT_GT(std::abs(intensity[2] / intensity[0] - 1.0), 0.01);
}

TEST_F(LightBetweenTest, FarBodiesCountWhereTheyAreBrightAlone) {
    const Triangles corner = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                                    plateMesh({0.5, 0, 0.5}, {0, 0.5, 0}, {0, 0, 0.5}, {1, 1}));
    const auto bodyAt = [&](double x_m, double temperature_K) {
        Entity entity = entityOf(modelOf(corner), greyDatabase(0.3, temperature_K));
        entity.pose.position_m = {x_m, 0, standingAltitude_m};
        entity.referencePoint_m = Vec3{};
        return entity;
    };
    const auto intensityOfFirst_W_sr = [&](const std::vector<Entity>& entities,
                                           int bounces = convergedBounces) {
        InteractiveRenderer irsg =
            rendererOf(entities, brightSettings(EngineChoice::rays, bounces), brightAtmosphere());
        look(irsg, {.azimuth_rad = -0.3, .elevation_rad = 0.6, .fieldOfView_rad = 0.4});
        return irsg.measure().objects[0].intensity_W_sr;
    };
    const double alone = intensityOfFirst_W_sr({bodyAt(0.0, 300.0)});
    // As bright as each other they are lit as each alone; samples lie elsewhere in another frame.
    const std::vector<Entity> two{bodyAt(0.0, 300.0), bodyAt(-20.5, 300.0)};
    const double sampled = intensityOfFirst_W_sr(two, 0) / intensityOfFirst_W_sr({two[0]}, 0);
    EXPECT_NEAR(intensityOfFirst_W_sr(two) / alone, sampled, 3e-5); // to which reflections converge
    // A view factor of 1e-4 counts where it is of what is thousands of times brighter.
    EXPECT_GT(intensityOfFirst_W_sr({bodyAt(0.0, 300.0), bodyAt(-60.0, 2500.0)}) / alone, 1.005);
    // Near ones count as they are.
    EXPECT_GT(
        std::abs(intensityOfFirst_W_sr({bodyAt(0.0, 300.0), bodyAt(-1.2, 300.0)}) / alone - 1.0),
        1e-4);
}
