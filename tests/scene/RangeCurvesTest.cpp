#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/RangeGeometry.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/scene/RangeScenes.h"
#include "tests/support/SampleAircraft.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;
using namespace irsg::test::ranges;

namespace {

std::vector<double> rangesFrom(double nearest_m, double times, int count) {
    std::vector<double> ranges_m;
    for (int i = 0; i < count; ++i) {
        ranges_m.push_back(nearest_m * std::pow(times, static_cast<double>(i) / (count - 1)));
    }
    return ranges_m;
}

RenderReport along(InteractiveRenderer& irsg) {
    return irsg.render(Outputs::reports().alongRange()).reports.front();
}

long drawings(const InteractiveRenderer& irsg) {
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        if (stage.name == "drawing") {
            return stage.calls;
        }
    }
    return 0;
}

double rmsOf(const std::vector<double>& values) {
    return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
                     static_cast<double>(values.size()));
}
double worstOf(const std::vector<double>& values) {
    double worst = 0.0;
    for (const double value : values) {
        worst = std::max(worst, std::abs(value));
    }
    return worst;
}
std::vector<double> steps(const std::vector<double>& values) {
    std::vector<double> result(values.size());
    std::adjacent_difference(values.begin(), values.end(), result.begin());
    result.erase(result.begin());
    return result;
}

/// Logarithms of the intensity of the aircraft over range.
struct Curves {
    Aspect aspect;
    std::vector<double> ranges_m = rangesFrom(470.0, 40.0, 40);
    InteractiveRenderer irsg = generatorOf({sampleAircraft()}, 128);

    double drawnAt(double range_m) {
        look(irsg, aspect, range_m);
        return std::log(irsg.measure().all.intensity_W_sr);
    }
    std::vector<double> drawn() {
        std::vector<double> values;
        values.reserve(ranges_m.size());
        for (const double range_m : ranges_m) {
            values.push_back(drawnAt(range_m));
        }
        return values;
    }
    std::vector<double> interpolated(int tileSide_samples) {
        irsg.scene.settings = settingsOf(tileSide_samples);
        std::vector<double> values;
        for (const double range_m : ranges_m) {
            look(irsg, aspect, range_m);
            values.push_back(std::log(along(irsg).all.intensity_W_sr));
        }
        return values;
    }
};

std::vector<double> differences(const std::vector<double>& values,
                                const std::vector<double>& truth) {
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), truth.begin(), result.begin(), std::minus<>());
    return result;
}

void print(const std::string& name, const std::vector<double>& errors) {
    std::printf("%s: RMS %.1e, largest %.1e, step %.1e, bend %.1e\n", name.c_str(), rmsOf(errors),
                worstOf(errors), worstOf(steps(errors)), worstOf(steps(steps(errors))));
}

/// Neither the curve nor its slope jumps by more than three times the RMS.
void expectSmooth(const std::string& name, const std::vector<double>& errors) {
    constexpr double rounding = 1e-6; // of a sum of floats
    const double most = 3.0 * std::max(rmsOf(errors), rounding);
    EXPECT_LE(worstOf(steps(errors)), most) << name;
    EXPECT_LE(worstOf(steps(steps(errors))), most) << name;
    print(name, errors);
}

} // namespace

TEST(RangeGeometry, WeighFewNodesSoThatParabolasStayWhatTheyAre) {
    for (const double nearness : {0.0, 1e-6, 1e-3, 0.012, 1.0 / 64, 0.02, 0.035, 0.05, 1.0 / 16}) {
        double sum = 0.0, linear = 0.0, square = 0.0;
        for (const auto& [node, weight] : RangeGeometry::weightsAt(nearness)) {
            const double at = RangeGeometry::nodes[node];
            sum += weight, linear += weight * at, square += weight * at * at;
        }
        EXPECT_LE(RangeGeometry::weightsAt(nearness).size(), 4u);
        EXPECT_NEAR(sum, 1.0, 1e-13) << nearness;
        EXPECT_NEAR(linear, nearness, 1e-14) << nearness;
        EXPECT_NEAR(square, nearness * nearness, 1e-15) << nearness;
    }
    // At a node it is that node's alone, and the slope is the same on both sides.
    for (std::size_t node = 1; node + 1 < RangeGeometry::nodes.size(); ++node) {
        const double at = RangeGeometry::nodes[node], step = 1e-7;
        const auto weights = [](double nearness) {
            std::vector<double> all(RangeGeometry::nodes.size());
            for (const auto& [i, weight] : RangeGeometry::weightsAt(nearness)) {
                all[i] = weight;
            }
            return all;
        };
        EXPECT_EQ(RangeGeometry::weightsAt(at).size(), 1u);
        const std::vector<double> before = weights(at - step), here = weights(at),
                                  after = weights(at + step);
        for (std::size_t i = 0; i < here.size(); ++i) {
            EXPECT_NEAR(after[i] - here[i], here[i] - before[i], 1e-9) << node << ' ' << i;
        }
    }
}

TEST(RangeCurve, OfConvexBodiesIsTheirSolidAngle) {
    struct Body {
        const char* name;
        Triangles mesh;
        Aspect aspect;
        double most;
        bool hasCorner = false; ///< of the true curve: a side comes into sight
    };
    const std::vector<IrCodes> sides(6, one);
    const Body bodies[] = {
        {"sphere", sphereMesh(2.0, 48, 96, one), {0, 0}, 5e-4},
        {"box, nose on", boxMesh({2, 6, 1.5}, sides), {0, 0}, 1e-3},
        {"box, a degree beside", boxMesh({2, 6, 1.5}, sides), {1, 0}, 1e-3, true},
        {"box, from a corner", boxMesh({2, 6, 1.5}, sides), {40, 25}, 5e-4},
        {"rod", boxMesh({0.05, 6, 0.05}, sides), {62, 0}, 1e-3},
    };
    const double radiance_W_m2_sr =
        emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
    for (const Body& body : bodies) {
        InteractiveRenderer irsg = generatorOf({grey(body.mesh)});
        std::vector<double> errors, ofIrradiance, ofPixels;
        for (const double range_m : rangesFrom(120.0, 100.0, 40)) {
            look(irsg, body.aspect, range_m);
            const RenderReport report = along(irsg);
            const Vec3 from =
                irsg.view.viewpoint.position_m - irsg.scene.entities[0].pose.position_m;
            const double truth_sr = convexSolidAngle_sr(body.mesh, from);
            errors.push_back(report.all.intensity_W_sr /
                                 (radiance_W_m2_sr * truth_sr * range_m * range_m) -
                             1.0);
            // Seen at the axis, where cosines are near 1 and pixels alike.
            const double pitch = irsg.view.sensor.pixelPitch();
            ofIrradiance.push_back(report.all.irradiance_W_m2 * range_m * range_m /
                                       report.all.contrastIntensity_W_sr -
                                   1.0);
            ofPixels.push_back(report.all.coveredPixels * pitch * pitch / report.all.solidAngle_sr -
                               1.0);
        }
        EXPECT_LT(rmsOf(errors), body.most) << body.name;
        EXPECT_LT(worstOf(errors), 3.0 * body.most) << body.name;
        EXPECT_LE(worstOf(steps(errors)), body.hasCorner ? 2e-3 : 3.0 * rmsOf(errors)) << body.name;
        EXPECT_LT(worstOf(ofIrradiance), 2e-3) << body.name;
        EXPECT_LT(worstOf(ofPixels), 6e-3) << body.name;
        EXPECT_LE(drawings(irsg), 5) << body.name;
        std::printf("%-22s RMS %.1e, largest %.1e, step %.1e\n", body.name, rmsOf(errors),
                    worstOf(errors), worstOf(steps(errors)));
    }
}

TEST(RangeCurve, OfAHotAircraftSeenNoseOnIsRightAndSmoothInEveryMode) {
    Curves curves;
    const std::vector<double> truth = curves.interpolated(2048);
    const std::size_t middle = truth.size() / 2;
    const double ofNodes = curves.drawnAt(curves.ranges_m[middle]) - truth[middle];
    EXPECT_LT(std::abs(ofNodes), 4e-4) << "what interpolation leaves";
    std::printf("at 2048 %.1e\n", ofNodes);
    for (const auto& [size, most] : {std::pair{128, 4e-3}, {256, 2e-3}, {512, 1e-3}}) {
        const std::string name = "nose on, window " + std::to_string(size);
        const std::vector<double> errors = differences(curves.interpolated(size), truth);
        EXPECT_LT(rmsOf(errors), most) << name;
        EXPECT_LT(worstOf(errors), 2.5 * most) << name;
        expectSmooth(name, errors);
    }
    curves.irsg.scene.settings = settingsOf(128);
    print("nose on, window 128, each drawn", differences(curves.drawn(), truth));
}

TEST(RangeCurve, OfAHotAircraftIsRightAndSmooth) {
    for (const Aspect& aspect : {Aspect{3, 0}, Aspect{150, 12}}) {
        Curves curves;
        curves.aspect = aspect;
        const std::string name = "azimuth " + std::to_string(std::lround(aspect.azimuth_deg));
        const std::vector<double> curve = curves.interpolated(128);
        EXPECT_LE(drawings(curves.irsg), 5) << "probes for hot parts are rays";
        const std::vector<double> drawn = curves.drawn();
        // The truth is drawn with 1024 samples a side, some of it at every range for itself.
        const std::vector<double> truth = curves.interpolated(1024);
        std::vector<double> ofNodes;
        for (std::size_t i = 5; i < truth.size(); i += 20) {
            ofNodes.push_back(truth[i] - curves.drawnAt(curves.ranges_m[i]));
        }
        const std::vector<double> errors = differences(curve, truth);
        const std::vector<double> errorsOfDrawings = differences(drawn, truth);
        EXPECT_LT(worstOf(ofNodes), 6e-4) << "what interpolation leaves";
        EXPECT_LT(rmsOf(errors), 4e-3);
        EXPECT_LT(worstOf(errors), 1e-2);
        EXPECT_LT(rmsOf(errors), rmsOf(errorsOfDrawings));
        EXPECT_LT(3.0 * rmsOf(steps(steps(errors))), rmsOf(steps(steps(errorsOfDrawings))));
        expectSmooth(name, errors);
        print(name + ", each drawn", errorsOfDrawings);
        std::printf("at 1024 largest %.1e\n", worstOf(ofNodes));
    }
}

// Two walls one behind the other and a body of glass, in air in which the near side outshines the
// far one: what is drawn once moves with its slices.
TEST(RangeCurve, TakesStrongAirAlongAnObjectAtEveryRange) {
    Environment environment;
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(0.02);
    parameters.airTemperature_K = parameters.groundTemperature_K = 250.0;
    environment.add(std::make_shared<BeerLambert>(parameters));
    SignatureDatabase database = greyDatabase(emissivity, temperature_K);
    database.materials[2] = greyMaterial(0.3, 0.6);
    constexpr IrCodes glassCodes{1, 2};
    Triangles glass = boxMesh({0.8, 0.8, 0.8}, std::vector<IrCodes>(6, glassCodes));
    for (Triangle& triangle : glass) {
        for (Vec3& vertex : triangle.vertex) {
            vertex = vertex + Vec3{0, 2.5, 0};
        }
    }
    const Triangles mesh = joined(joined(plateMesh({-2, 4, 0}, {0, 0, 2}, {1.5, 0, 0}, one),
                                         plateMesh({2, -4, 0}, {0, 0, 2}, {1.5, 0, 0}, one)),
                                  glass);
    InteractiveRenderer irsg = generatorOf({entityOf(modelOf(mesh), database)}, 512);
    irsg.scene.environment = environment;
    bool wasSliced = false;
    for (const double range_m : rangesFrom(110.0, 8.0, 9)) {
        look(irsg, {10, 5}, range_m);
        const ObjectRadiometry drawn = irsg.measure().all, curve = along(irsg).all;
        EXPECT_NEAR(curve.intensity_W_sr / drawn.intensity_W_sr, 1.0, 2e-3) << range_m;
        EXPECT_NEAR(curve.contrastIntensity_W_sr / drawn.contrastIntensity_W_sr, 1.0, 4e-3)
            << range_m;
        EXPECT_EQ(curve.atmosphereError, drawn.atmosphereError);
        RenderSettings settings = irsg.scene.settings;
        settings.atmosphereSliceFrom = 1e9;
        irsg.scene.settings = settings;
        wasSliced |=
            std::abs(irsg.measure().all.intensity_W_sr / drawn.intensity_W_sr - 1.0) > 5e-3;
        settings.atmosphereSliceFrom = RenderSettings{}.atmosphereSliceFrom;
        irsg.scene.settings = settings;
    }
    EXPECT_TRUE(wasSliced) << "slices matter here";
}

// The directions of the sky that a polished surface reflects hang from the horizon of its altitude,
// which is rounded by the range.
TEST(RangeCurve, OfAPolishedBodyIsSampledOnceForAllRanges) {
    AtmosphereSmartParameters parameters;
    parameters.resolution_per_cm = 15;
    SignatureDatabase database = greyDatabase(0.3, temperature_K);
    database.materials[1].surfaceModel = "ggx";
    database.materials[1].roughness = 0.3;
    InteractiveRenderer irsg = generatorOf(
        {entityOf(modelOf(boxMesh({2, 6, 1.5}, std::vector<IrCodes>(6, one))), database)}, 64);
    irsg.scene.environment = {};
    irsg.scene.environment.add(std::make_shared<const AtmosphereSmart>(parameters));
    irsg.scene.settings.background = BackgroundMode::environment;
    irsg.scene.settings.backgroundRows = 0;
    irsg.scene.settings.ambientReflection = ReflectionMode::smart;
    irsg.scene.settings.hotSpots = false;
    irsg.scene.entities[0].pose.position_m.z = 250.0;
    for (const double range_m : rangesFrom(120.0, 400.0, 12)) {
        look(irsg, {40, 0}, range_m);
        (void)along(irsg);
    }
    EXPECT_LE(drawings(irsg), 5);
}

// A search looks at many ranges and asks for one: one drawing, at which it is right, and whose
// errors hold what perspective leaves elsewhere.
TEST(RangeCurve, FromOneDrawingIsRightThereAndWithinItsErrorElsewhere) {
    Curves curves;
    curves.aspect = {150, 12}; // the hot pipes are nearer than the nose
    InteractiveRenderer& irsg = curves.irsg;
    irsg.scene.settings = settingsOf(512);
    for (const double sampledAt_m : {500.0, 4000.0}) {
        for (const double range_m : {500.0, 700.0, 4000.0, 40000.0}) {
            look(irsg, curves.aspect, range_m);
            const ObjectRadiometry nodes =
                irsg.render(Outputs::reports().alongRange().withErrors(false)).reports.front().all;
            const long before = drawings(irsg);
            const RenderReport report =
                irsg.render(Outputs::reports().alongRangeFrom(sampledAt_m).withErrors())
                    .reports.front();
            EXPECT_GT(report.alongRangeReach_m, 0.0);
            EXPECT_LE(drawings(irsg) - before, 1);
            const double off = report.all.intensity_W_sr / nodes.intensity_W_sr - 1.0;
            const double error = report.all.errors->intensity_W_sr.sum() / nodes.intensity_W_sr;
            EXPECT_LT(std::abs(off), error + 4e-4) << sampledAt_m << " to " << range_m;
            if (sampledAt_m == range_m) {
                EXPECT_LT(std::abs(off), 2e-3) << range_m;
            }
            std::printf("from %g m at %g m: off by %.1e of %.1e\n", sampledAt_m, range_m, off,
                        error);
        }
    }
}

// Two searches of one aspect differ in nothing that ranges between them were asked for.
TEST(RangeCurve, FromOneDrawingDoesNotDependOnWhatWasAskedBefore) {
    InteractiveRenderer irsg = generatorOf({sampleAircraft()}, 128);
    const auto at = [&](double range_m) {
        look(irsg, {70, 5}, range_m);
        const Outputs::Reports outputs = Outputs::reports().alongRangeFrom(3000.0);
        return irsg.render(outputs).reports.front().all.intensity_W_sr;
    };
    const double first = at(5000.0);
    for (const double range_m : {900.0, 3000.0, 20000.0}) {
        (void)at(range_m);
    }
    EXPECT_EQ(at(5000.0), first);
}

TEST(RangeCurve, DrawsWhatIsNearOrCutOffOrOverlapsOrIsNotLookedAt) {
    const Triangles box = boxMesh({2, 6, 1.5}, std::vector<IrCodes>(6, one));
    const auto isDrawn = [](InteractiveRenderer& irsg) {
        const ObjectRadiometry drawn = irsg.measure().all, curve = along(irsg).all;
        return drawn.intensity_W_sr == curve.intensity_W_sr &&
               drawn.irradiance_W_m2 == curve.irradiance_W_m2;
    };
    InteractiveRenderer irsg = generatorOf({grey(box)});
    look(irsg, {30, 10}, 300.0);
    EXPECT_FALSE(isDrawn(irsg));

    look(irsg, {30, 10}, 90.0);
    EXPECT_TRUE(isDrawn(irsg)) << "nearer than 16 times what it reaches";

    irsg.view.viewpoint.position_m = irsg.scene.entities[0].pose.position_m;
    EXPECT_TRUE(isDrawn(irsg)) << "the camera is in its middle, at range 0";

    look(irsg, {30, 10}, 300.0);
    Sensor narrow = irsg.view.sensor;
    narrow.horizontalFieldOfView_rad = 0.02;
    irsg.view.sensor = narrow;
    EXPECT_TRUE(isDrawn(irsg)) << "cut off";

    look(irsg, {30, 10}, 300.0);
    irsg.scene.entities[0].pose = {{3, 0, standingAltitude_m}, {}};
    EXPECT_TRUE(isDrawn(irsg)) << "the sensor looks beside it";

    irsg.scene.entities[0].pose = {{0, 0, standingAltitude_m}, {}};
    for (const auto& [name, change] :
         {std::pair{"supersampling", +[](RenderSettings& s) { s.tileSide_samples = 0; }},
          {"published zoom",
           +[](RenderSettings& s) { s.tileStrategy = TileStrategy::published; }}}) {
        RenderSettings settings = settingsOf(256);
        change(settings);
        irsg.scene.settings = settings;
        look(irsg, {30, 10}, 300.0);
        EXPECT_TRUE(isDrawn(irsg)) << name;
    }

    Entity behind = grey(box);
    behind.pose.position_m = irsg.scene.entities[0].pose.position_m + Vec3{0, -20, 0};
    InteractiveRenderer two = generatorOf({irsg.scene.entities[0], behind});
    look(two, {5, 2}, 300.0);
    EXPECT_TRUE(isDrawn(two)) << "one before the other";
}

TEST(RangeCurve, DrawsOtherObjectsBesideTheOneThatIsLookedAt) {
    const Triangles box = boxMesh({2, 6, 1.5}, std::vector<IrCodes>(6, one));
    Entity beside = grey(sphereMesh(1.0, 16, 32, one));
    InteractiveRenderer irsg = generatorOf({grey(box), beside});
    irsg.scene.entities[0].pose = {{0, 0, standingAltitude_m}, {}};
    irsg.scene.entities[1].pose = {{12, 0, standingAltitude_m}, {}};
    look(irsg, {0, 0}, 300.0);
    const RenderReport drawn = irsg.measure(), curve = along(irsg);
    EXPECT_EQ(curve.objects[1].intensity_W_sr, drawn.objects[1].intensity_W_sr);
    EXPECT_NE(curve.objects[0].intensity_W_sr, drawn.objects[0].intensity_W_sr);
    EXPECT_NEAR(curve.objects[0].intensity_W_sr / drawn.objects[0].intensity_W_sr, 1.0, 1e-2);
    EXPECT_NEAR(curve.all.intensity_W_sr,
                curve.objects[0].intensity_W_sr + curve.objects[1].intensity_W_sr, 1e-9);
}

TEST(RangeCurve, HasTheSameBitsForAnyNumberOfThreadsAndInAnyOrder) {
    const std::vector<double> ranges_m = rangesFrom(500.0, 20.0, 7);
    const auto curveOf = [&](unsigned threads, bool isReversed) {
        setMostThreads(threads);
        InteractiveRenderer irsg = generatorOf({sampleAircraft()}, 128);
        std::vector<double> curve(ranges_m.size());
        for (std::size_t i = 0; i < ranges_m.size(); ++i) {
            const std::size_t k = isReversed ? ranges_m.size() - 1 - i : i;
            look(irsg, {150, 12}, ranges_m[k]);
            curve[k] = along(irsg).all.contrastIntensity_W_sr;
        }
        setMostThreads(0);
        return curve;
    };
    const std::vector<double> curve = curveOf(1, false);
    EXPECT_EQ(curve, curveOf(3, false));
    EXPECT_EQ(curve, curveOf(0, true)) << "the direction that nodes are drawn from is rounded";
}

TEST(RangeCurve, LeavesImagesAndOtherSweepsAsTheyAre) {
    InteractiveRenderer irsg = generatorOf({sampleAircraft()}, 128);
    look(irsg, {150, 12}, 2000.0);
    const double image = irsg.imageWithReport().report.all.intensity_W_sr;
    const double drawn = irsg.measure().all.intensity_W_sr;
    EXPECT_NEAR(image / drawn, 1.0, 1e-5);
    along(irsg);
    EXPECT_EQ(irsg.measure().all.intensity_W_sr, drawn);
    EXPECT_EQ(irsg.imageWithReport().report.all.intensity_W_sr, image);
}
