#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/sampling/HotSpots.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes skin{1, 1}, hot{2, 1};
constexpr double skin_K = 280.0, hot_K = 900.0;
constexpr double wallWidth_m = 30.0, wallHeight_m = 10.0, diameter_m = 0.12;
constexpr double pixel_rad = 8e-5;

/// A number from 0 to 1, another for every step, irrational to any lattice.
double part(int step, double ratio) {
    return std::fmod((step + 0.5) * ratio, 1.0);
}

double radiance_W_m2_sr(double temperature_K) {
    return bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
}

Entity hotAndCold(const Triangles& mesh) {
    SignatureDatabase database;
    database.materials[1] = greyMaterial(1.0);
    database.temperatures[1] = fixedTemperature(skin_K);
    database.temperatures[2] = fixedTemperature(hot_K);
    return entityOf(modelOf(mesh), database);
}

/// A cold wall with hot balls and plates before it, all over it.
struct Spots {
    Triangles mesh = plateMesh({}, {0, 0, 0.5 * wallHeight_m}, {0.5 * wallWidth_m, 0, 0}, skin);
    double seen_m2 = 0.0; ///< from the front and from far

    explicit Spots(int count) {
        constexpr double far_m = 1e5, lean_m = 0.02, half_m = 0.5 * diameter_m;
        const Triangles ball = sphereMesh(half_m, 8, 16, hot);
        for (int i = 0; i < count; ++i) {
            const Vec3 place{wallWidth_m * 0.96 * (part(i, 0.7548776662) - 0.5), 0.1,
                             wallHeight_m * 0.96 * (part(i, 0.5698402910) - 0.5)};
            if (i % 2) {
                mesh =
                    joined(mesh, plateMesh(place, {lean_m, 0, half_m}, {half_m, 0, -lean_m}, hot));
                seen_m2 += 4.0 * (half_m * half_m + lean_m * lean_m);
                continue;
            }
            Triangles moved = ball;
            for (Triangle& triangle : moved) {
                for (Vec3& vertex : triangle.vertex) {
                    vertex = vertex + place;
                }
            }
            mesh = joined(mesh, moved);
            seen_m2 += convexSolidAngle_sr(ball, {0, far_m, 0}) * far_m * far_m;
        }
    }
    double truth_W_sr() const {
        return (wallWidth_m * wallHeight_m - seen_m2) * radiance_W_m2_sr(skin_K) +
               seen_m2 * radiance_W_m2_sr(hot_K);
    }
};

RenderSettings settingsOf(int tileSide_samples, bool hotSpots = true) {
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::constant;
    settings.tileSide_samples = tileSide_samples;
    settings.hotSpots = hotSpots;
    return settings;
}

InteractiveRenderer& generator() {
    static InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    return irsg;
}

/// At the first object, which stands at some phase of the pixels: the camera turns by a part of
/// one, so that what it sees of the object stays the same.
void look(InteractiveRenderer& irsg, double azimuth_rad, double elevation_rad, double range_m,
          int phase) {
    const Vec3 place_m{0, 0, standingAltitude_m};
    irsg.scene.entities[0].pose = {place_m, {}};
    test::look(irsg, {.range_m = range_m,
                      .azimuth_rad = azimuth_rad,
                      .elevation_rad = elevation_rad,
                      .width_px = 400,
                      .height_px = 320,
                      .fieldOfView_rad = 2.0 * std::atan(200.0 * pixel_rad)});
    const Viewpoint camera = irsg.view.viewpoint;
    const double pixel_m = pixel_rad * range_m;
    irsg.view.viewpoint = Viewpoint::lookAt(
        camera.position_m, place_m + camera.right * (part(phase, 0.61803398875) * pixel_m) +
                               camera.up * (part(phase, 0.41421356237) * pixel_m));
}

struct Errors {
    double squares = 0.0, worst = 0.0;
    int count = 0;

    void add(double error) {
        squares += error * error;
        worst = std::max(worst, std::abs(error));
        ++count;
    }
    double rms() const { return std::sqrt(squares / count); }
};

/// Errors along a curve, at each of its places for several phases of the pixels. What phases
/// scatter is chance, of which neighbours know nothing; a cliff of the curve is a step of their
/// mean.
struct CurveErrors {
    Errors all;
    double step = 0.0;        ///< largest, between the means of neighbouring places
    double stepOfPhase = 0.0; ///< the same of single phases
    std::vector<double> before;

    void add(const std::vector<double>& ofPhases) {
        double change = 0.0;
        for (std::size_t i = 0; i < ofPhases.size(); ++i) {
            all.add(ofPhases[i]);
            if (!before.empty()) {
                const double own = ofPhases[i] - before[i];
                stepOfPhase = std::max(stepOfPhase, std::abs(own));
                change += own / static_cast<double>(ofPhases.size());
            }
        }
        step = std::max(step, std::abs(change));
        before = ofPhases;
    }
};

/// No cliff: the curve never steps by more than three times its RMS, or than three times what the
/// truth is known to.
void expectWithoutAJump(const CurveErrors& errors, double known, const std::string& name) {
    EXPECT_LE(errors.step, 3.0 * std::max(errors.all.rms(), known)) << name;
    std::printf("%s: RMS %.2e, largest %.2e, step %.2e, of one phase %.2e\n", name.c_str(),
                errors.all.rms(), errors.all.worst, errors.step, errors.stepOfPhase);
}

/// From 2 to 40 km.
CurveErrors errorsOf(InteractiveRenderer& irsg, const Spots& spots) {
    constexpr int places = 5, phases = 3;
    CurveErrors errors;
    for (int place = 0; place < places; ++place) {
        std::vector<double> ofPhases;
        for (int phase = 0; phase < phases; ++phase) {
            look(irsg, 0.0, 0.0, 2e3 * std::pow(20.0, static_cast<double>(place) / (places - 1)),
                 phases * place + phase);
            ofPhases.push_back(irsg.measure().all.intensity_W_sr / spots.truth_W_sr() - 1.0);
        }
        errors.add(ofPhases);
    }
    return errors;
}

} // namespace

TEST(HotSpotSampling, KeepTheirIntensityHoweverManyTheyAre) {
    InteractiveRenderer& irsg = generator();
    // The truth is that of far away, where a wall of 30 m has no middle that is nearer than its
    // ends.
    constexpr double known = 5e-5;
    for (const auto& [size, most] : {std::pair{128, 0.007}, {256, 0.003}, {512, 0.001}}) {
        double before = 0.0;
        for (const int count : {1, 4, 16, 17, 40, 90, 200}) {
            const Spots spots(count);
            irsg.scene.entities = {hotAndCold(spots.mesh)};
            irsg.scene.settings = settingsOf(size);
            const CurveErrors errors = errorsOf(irsg, spots);
            const std::string name =
                std::to_string(count) + " spots, window " + std::to_string(size);
            EXPECT_LT(errors.all.rms(), most) << name;
            EXPECT_LT(errors.all.worst, 3.0 * most) << name;
            EXPECT_LT(errors.stepOfPhase, 3.0 * most) << name;
            expectWithoutAJump(errors, known, name);
            // Nor do some more spots make it three times as bad, but for few, which are drawn as
            // finely as can be.
            if (before > 0.0) {
                EXPECT_LT(errors.all.rms(), 3.0 * std::max(before, 0.1 * most) + 1e-4) << name;
            }
            before = errors.all.rms();
        }
    }
}

TEST(HotSpotSampling, OfSeveralStatesAreDrawnOnceForAll) {
    // Cold at no power, hot at full power.
    Spots spots(3);
    Entity wall = hotAndCold(spots.mesh);
    SignatureDatabase database = *wall.database;
    database.temperatures[2].terms.base_K = skin_K;
    database.temperatures[2].terms.power = LookupTable({0.0, 1.0}, {0.0, hot_K - skin_K});
    wall.database = std::make_shared<const SignatureDatabase>(database);
    const auto measured = [&](const std::vector<double>& powers, bool areShared, long& drawings) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = environmentOf(ConstantAtmosphere{});
        irsg.scene.settings = settingsOf(128);
        Entity entity = wall;
        for (const double power : powers) {
            EntityState state;
            state.power = power;
            if (areShared) {
                entity.otherStates.push_back(state);
            }
        }
        irsg.scene.entities = {entity};
        look(irsg, 0.0, 0.0, 8000.0, 2);
        std::vector<double> intensities_W_sr;
        for (const double power : powers) {
            EntityState state;
            state.power = power;
            irsg.scene.entities[0].state = state;
            intensities_W_sr.push_back(irsg.measure().all.intensity_W_sr);
        }
        drawings = 0;
        for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
            drawings += stage.name == "factor sums" ? stage.calls : 0;
        }
        return intensities_W_sr;
    };
    long shared = 0, apart = 0, reversed = 0;
    const std::vector<double> together = measured({0.0, 1.0}, true, shared);
    const std::vector<double> alone = measured({0.0, 1.0}, false, apart);
    EXPECT_EQ(shared, 1);
    EXPECT_EQ(apart, 2);
    const std::vector<double> backwards = measured({1.0, 0.0}, true, reversed);
    EXPECT_EQ(together[0], backwards[1]) << "whichever was first";
    EXPECT_EQ(together[1], backwards[0]);
    EXPECT_NEAR(together[0], alone[0], 2e-3 * alone[0]);
    EXPECT_EQ(together[1], alone[1]) << "whose hot spots are those of both";
}

TEST(HotSpotSampling, ThatAreHiddenCostNothingAndChangeNothing) {
    // From behind, a screen hides them all.
    InteractiveRenderer& irsg = generator();
    const Triangles screen = plateMesh({0, -0.5, 0}, {0, 0, 7}, {17, 0, 0}, skin);
    irsg.scene.entities = {hotAndCold(joined(Spots(20).mesh, screen))};
    for (const int size : {128, 256}) {
        look(irsg, pi, 0.0, 4e3, 1);
        irsg.scene.settings = settingsOf(size, true);
        const RenderedImage with = irsg.imageWithReport();
        irsg.scene.settings = settingsOf(size, false);
        const RenderedImage without = irsg.imageWithReport();
        EXPECT_EQ(with.report.tiles.size(), without.report.tiles.size());
        EXPECT_EQ(with.report.all.intensity_W_sr, without.report.all.intensity_W_sr);
        EXPECT_EQ(with.image.primary().values, without.image.primary().values);

        look(irsg, 0.0, 0.0, 4e3, 1);
        irsg.scene.settings = settingsOf(size, true);
        EXPECT_GT(irsg.imageWithReport().report.tiles.size(), 10u);
    }
}

TEST(HotSpotSampling, AreHiddenWhereAProbeFindsSomethingBeforeAllOfThem) {
    const HotSpot part{{10.2, 10.2, 12.8, 11.6}, 100.0};
    SampleTile probe;
    probe.blockX = 5, probe.blockY = 4;
    probe.blocksWide = 12, probe.blocksHigh = 14;
    const auto samplesAt = [&](double distance_m) {
        GeometrySamples samples;
        samples.width = probe.width(), samples.height = probe.height();
        const auto count = static_cast<std::size_t>(samples.width * samples.height);
        samples.opaque.assign(4 * count, 1.0f);
        samples.distances_m.assign(count, static_cast<float>(distance_m));
        return samples;
    };
    EXPECT_TRUE(isHidden(part, probe, samplesAt(99.0)));
    EXPECT_FALSE(isHidden(part, probe, samplesAt(100.0)));
    EXPECT_FALSE(isHidden(part, probe, samplesAt(101.0)));
    // One block that is open, over the part, beside it and far from it. Rows run upwards.
    for (const auto& [x, y, hidden] : {std::tuple{11, 10, false},
                                       {9, 9, false},
                                       {13, 12, false},
                                       {14, 10, true},
                                       {11, 13, true},
                                       {7, 10, true}}) {
        GeometrySamples samples = samplesAt(99.0);
        const int row = probe.blocksHigh - 1 - (y - 4);
        samples.distances_m[static_cast<std::size_t>(row * probe.blocksWide + x - 5)] = 200.0f;
        EXPECT_EQ(isHidden(part, probe, samples), hidden) << x << ", " << y;
    }
}

TEST(HotSpotSampling, InPiecesWithoutEndShareBoxesThatHoldThemAll) {
    Triangles mesh;
    constexpr int pieces = 1500;
    for (int i = 0; i < pieces; ++i) {
        const Triangles one =
            plateMesh({100.0 * part(i, 0.7548776662), 0, 100.0 * part(i, 0.56984029)}, {0, 0, 0.01},
                      {0.01, 0, 0}, hot);
        mesh.insert(mesh.end(), one.begin(), one.end());
    }
    const auto boxes = connectedPieces(*modelOf(mesh)->mesh(), hot);
    EXPECT_LE(boxes.size(), mostPieces);
    EXPECT_GT(boxes.size(), mostPieces / 4);
    double area_m2 = 0.0;
    for (const BoundingBox& box : boxes) {
        area_m2 += (box.max.x - box.min.x) * (box.max.z - box.min.z);
    }
    EXPECT_LT(area_m2, 0.9 * 100.0 * 100.0);
    for (const Triangle& triangle : mesh) {
        EXPECT_TRUE(std::ranges::any_of(boxes, [&](const BoundingBox& box) {
            const Vec3 c = triangle.vertex[0];
            return c.x >= box.min.x - 1e-4 && c.x <= box.max.x + 1e-4 && c.z >= box.min.z - 1e-4 &&
                   c.z <= box.max.z + 1e-4;
        }));
    }
}

TEST(HotAircraft, TurnsWithoutAJump) {
    // A fuselage with wings and four hot pipes, in steps of a degree; the truth has 2048 samples.
    Triangles mesh = boxMesh({1.5, 14.0, 1.5}, std::vector<IrCodes>(6, skin));
    mesh = joined(mesh, plateMesh({}, {18.0, 0, 0}, {0, 2.0, 0}, skin));
    for (const double x : {-9.0, -5.0, 5.0, 9.0}) {
        Triangles pipe = boxMesh({0.15, 0.6, 0.1}, std::vector<IrCodes>(6, hot));
        for (Triangle& triangle : pipe) {
            for (Vec3& vertex : triangle.vertex) {
                vertex = vertex + Vec3{x, -2.2, -0.4};
            }
        }
        mesh = joined(mesh, pipe);
    }
    InteractiveRenderer& irsg = generator();
    irsg.scene.entities = {hotAndCold(mesh)};
    const auto intensityAt = [&](int degree, int size, int phase) {
        irsg.scene.settings = settingsOf(size);
        look(irsg, radians(degree), radians(4.0), 5e3, phase);
        return irsg.measure().all.intensity_W_sr;
    };
    constexpr int first_deg = 82, aspects = 10, phases = 4;
    // It is seen from the same place at every phase.
    std::vector<double> truth_W_sr;
    truth_W_sr.reserve(aspects);
    for (int i = 0; i < aspects; ++i) {
        truth_W_sr.push_back(intensityAt(first_deg + i, 2048, i));
    }
    for (const auto& [size, most] : {std::pair{128, 0.012}, {256, 0.005}, {512, 0.002}}) {
        CurveErrors errors;
        for (int i = 0; i < aspects; ++i) {
            std::vector<double> ofPhases;
            ofPhases.reserve(phases);
            for (int phase = 0; phase < phases; ++phase) {
                ofPhases.push_back(intensityAt(first_deg + i, size, phases * i + phase) /
                                       truth_W_sr[static_cast<std::size_t>(i)] -
                                   1.0);
            }
            errors.add(ofPhases);
        }
        EXPECT_LT(errors.all.rms(), most) << size;
        EXPECT_LT(errors.all.worst, 3.0 * most) << size;
        EXPECT_LT(errors.stepOfPhase, 3.0 * most) << size;
        expectWithoutAJump(errors, 5e-5, "hot aircraft, window " + std::to_string(size));
    }
}

TEST(LongThinBody, KeepsItsIntensityFromOneAspectToTheNext) {
    // 86 x 4 pixels and slimmer, seen from its edge and ever more from above.
    InteractiveRenderer& irsg = generator();
    for (const auto& [thickness_m, most] : {std::pair{4.0, 3e-4}, {1.2, 6e-4}, {0.4, 1e-3}}) {
        const Triangles mesh =
            boxMesh({43.0, 30.0, 0.5 * thickness_m}, std::vector<IrCodes>(6, skin));
        irsg.scene.entities = {hotAndCold(mesh)};
        irsg.scene.settings = settingsOf(256);
        CurveErrors errors;
        constexpr int aspects = 32, phases = 4;
        for (int aspect = 0; aspect < aspects; ++aspect) {
            std::vector<double> ofPhases;
            for (int phase = 0; phase < phases; ++phase) {
                look(irsg, 0.0, radians(0.025 * aspect), 1.0 / pixel_rad, phases * aspect + phase);
                const Vec3 away =
                    irsg.view.viewpoint.position_m - irsg.scene.entities[0].pose.position_m;
                const double truth =
                    radiance_W_m2_sr(skin_K) * convexSolidAngle_sr(mesh, away) * dot(away, away);
                ofPhases.push_back(irsg.measure().all.intensity_W_sr / truth - 1.0);
            }
            errors.add(ofPhases);
        }
        EXPECT_LT(errors.all.rms(), most) << thickness_m;
        EXPECT_LT(errors.all.worst, 3.0 * most) << thickness_m;
        EXPECT_LT(errors.stepOfPhase, 3.0 * most) << thickness_m;
        char name[60];
        std::snprintf(name, sizeof name, "86 x %.1f px", thickness_m);
        expectWithoutAJump(errors, 1e-5, name);
    }
}
