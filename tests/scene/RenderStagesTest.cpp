// Stages of the renderer by themselves, on values that the test fills.
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/scene/FramePlanner.h"
#include "irsg/scene/SceneEvaluator.h"
#include "irsg/scene/SurfaceSampler.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};

/// An engine that fails a test which samples.
class NoEngine : public SampleEngine {
  public:
    std::future<void> post(std::function<void()>) override { throw LogicError("sampled"); }
    std::string description() const override { return "none"; }
    int largestSide() const override { return largestDrawing; }
    void renderRadiance(const SheetScene&, RadianceSamples&) override {
        throw LogicError("sampled");
    }
    void sampleGeometry(const SheetScene&, bool, GeometrySamples&) override {
        throw LogicError("sampled");
    }
    double takeRenderSeconds() override { return 0.0; }
};

/// The stages before sampling, without an engine.
struct Stages {
    const RadianceTerms& terms = RadianceTerms::standard();
    StageClock clock;
    OccluderStacks occluderStacks;
    PreparedEntities prepared;
    TerrainRays terrainRays;
    NoEngine engine;
    SceneEvaluator evaluator{terms, occluderStacks, clock};
    SurfaceSampler sampler{terms, clock};
    FramePlanner planner{terms, prepared, sampler, clock};

    SceneEvaluation evaluate(FrameRequest& request) {
        return evaluator.evaluate(request, planner.geometry(request));
    }
    SceneEvaluation evaluate(FrameRequest&& request) { return evaluate(request); }
    FramePlan plan(const Scene& scene, const SensorView& view, const Outputs& outputs) {
        FrameRequest request(scene, view, outputs);
        SceneEvaluation evaluation = evaluate(request);
        const FrameBackgrounds backgrounds =
            evaluator.backgrounds(request, evaluation, terrainRays);
        std::vector<SurfaceItem> items = surfaceItems(scene.entities, evaluation.surfaceRows());
        const SceneSurfaces surfaces{scene,
                                     {engine, terrainRays, false, "none", {}, nullptr},
                                     std::move(evaluation),
                                     {},
                                     std::move(items),
                                     {}};
        return planner.plan(request, surfaces, backgrounds);
    }
};

/// Balls of 1 m radius at these places across the line of sight.
Scene ballsAt(const std::vector<double>& north_m) {
    const auto ball = modelOf(sphereMesh(1.0, 8, 16, one));
    Scene scene;
    scene.settings = RenderSettings::direct();
    for (const double y : north_m) {
        scene.entities.push_back(entityOf(ball, greyDatabase(0.9, 320.0)));
        scene.entities.back().pose.position_m = {0.0, y, 1000.0};
    }
    return scene;
}

/// From the east, a pixel of 1 mrad.
SensorView from(double range_m) {
    return {sensorOf(64, 64, degrees(64e-3)),
            Viewpoint::lookAt({range_m, 0.0, 1000.0}, {0.0, 0.0, 1000.0}, {0.0, 0.0, 1.0},
                              {0.0, 1.0, 0.0})};
}

std::vector<int> numbersOf(const std::vector<ObjectExtent>& objects) {
    std::vector<int> numbers;
    for (const ObjectExtent& object : objects) {
        numbers.push_back(object.entity);
    }
    return numbers;
}

using Numbers = std::vector<int>;

} // namespace

TEST(FramePlanner, TakesWhatIsNarrowerThanTheLimitAsAPoint) {
    Stages stages;
    const Scene scene = ballsAt({0.0});
    const FramePlan near = stages.plan(scene, from(1000.0), Outputs::image());
    EXPECT_EQ(numbersOf(near.drawn), Numbers{0});
    EXPECT_TRUE(near.points.empty());
    const FramePlan far = stages.plan(scene, from(1e6), Outputs::image());
    EXPECT_TRUE(far.drawn.empty());
    EXPECT_EQ(numbersOf(far.points), Numbers{0});
    EXPECT_EQ(numbersOf(far.seen), Numbers{0});
}

TEST(FramePlanner, DrawsPointsThatShareTheirPlaceInTheFrame) {
    Stages stages;
    const FramePlan plan = stages.plan(ballsAt({0.0, 0.5, 3000.0}), from(1e6), Outputs::image());
    EXPECT_EQ(numbersOf(plan.drawn), (Numbers{0, 1}));
    EXPECT_EQ(numbersOf(plan.points), Numbers{2});
}

TEST(FramePlanner, LeavesOutWhatIsOutsideTheFrame) {
    Stages stages;
    const FramePlan plan = stages.plan(ballsAt({0.0, 500.0}), from(1000.0), Outputs::image());
    EXPECT_EQ(numbersOf(plan.seen), Numbers{0});
}

TEST(FramePlanner, InterpolatesTheObjectThatASweepOfRangesLooksAt) {
    Stages stages;
    const Scene scene = ballsAt({0.0, 20.0});
    const FramePlan plan = stages.plan(scene, from(1000.0), Outputs::reports().alongRange());
    ASSERT_EQ(plan.alongRange.size(), 1u);
    EXPECT_EQ(plan.alongRange[0].object.entity, 0);
    EXPECT_EQ(numbersOf(plan.seen), Numbers{1});
    EXPECT_EQ(numbersOf(plan.drawn), Numbers{1});
    const FramePlan picture = stages.plan(scene, from(1000.0), Outputs::image());
    EXPECT_TRUE(picture.alongRange.empty());
}

TEST(SceneEvaluator, SharesAnEvaluatedSceneBetweenViewsAndNotBetweenTemperatures) {
    Stages stages;
    const Scene scene = ballsAt({0.0});
    const SensorView near = from(1000.0), far = from(2000.0);
    const SceneEvaluation first = stages.evaluate({scene, near, Outputs::image()});
    const SceneEvaluation second = stages.evaluate({scene, far, Outputs::image()});
    EXPECT_EQ(first.evaluated, second.evaluated);
    EXPECT_DOUBLE_EQ(first.ranges_m().front(), 1000.0);
    EXPECT_DOUBLE_EQ(second.ranges_m().front(), 2000.0);

    Scene warmer = scene;
    warmer.entities.front() = entityOf(scene.entities.front().model, greyDatabase(0.9, 330.0));
    warmer.entities.front().pose = scene.entities.front().pose;
    const SceneEvaluation third = stages.evaluate({warmer, near, Outputs::image()});
    EXPECT_NE(first.evaluated, third.evaluated);
    EXPECT_LT(first.evaluated->radiometry.thermal_W_m2_sr(0),
              third.evaluated->radiometry.thermal_W_m2_sr(0));
}
