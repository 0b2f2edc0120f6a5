#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <osg/Group>

#include "tests/scene/RangeScenes.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/TerrainSheets.h"

using namespace irsg;
using namespace irsg::test;
using namespace irsg::test::ranges;

namespace {

/// A rectangle with a texture of squares from black to white, given about the standing place.
struct Sheet {
    Vec3 corner_m, along_m, up_m;
    int squares = 1;
};

std::shared_ptr<const Terrain> terrainOf(const std::vector<Sheet>& sheets) {
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const auto& [corner, along, up, squares] : sheets) {
        group->addChild(sheet(corner, along, up, textureOf(squares, [](int x, int y) {
                                  return 0.5f * static_cast<float>((7 * x + 3 * y) % 5);
                              })));
    }
    return terrainOfGraph(*group, "sheets", {0, 0, standingAltitude_m});
}

/// A box before ground of bright and dark squares that lies 40 m below it.
InteractiveRenderer boxOverGround(std::vector<Sheet> more = {}) {
    InteractiveRenderer irsg =
        generatorOf({grey(boxMesh({2, 6, 1.5}, std::vector<IrCodes>(6, one)))}, 1024);
    more.push_back({{-6000, -6000, -40}, {12000, 0, 0}, {0, 12000, 0}, 1024});
    irsg.scene.terrain = terrainOf(more);
    irsg.scene.settings.terrain = {1.0, 0.0};
    return irsg;
}

/// The reports of a drawing for the range alone, and of one from another.
struct Sampled {
    RenderReport drawn, fromOne;
    double off() const {
        return fromOne.all.contrastIntensity_W_sr / drawn.all.contrastIntensity_W_sr - 1.0;
    }
    double error() const {
        return fromOne.all.errors->contrastIntensity_W_sr.sum() /
               std::abs(drawn.all.contrastIntensity_W_sr);
    }
};

Sampled sampled(InteractiveRenderer& irsg, double sampledFrom_m) {
    return {
        irsg.measure(),
        irsg.render(Outputs::reports().alongRangeFrom(sampledFrom_m).withErrors()).reports.front()};
}

} // namespace

// What is behind a target changes with the range, how it is seen does not.
TEST(RangeCurve, FromOneDrawingHasTheTerrainBehindOfEachRange) {
    InteractiveRenderer irsg = boxOverGround();
    std::vector<double> backgrounds;
    for (const double sampledFrom_m : {300.0, 3000.0}) {
        for (const double range_m : {120.0, 300.0, 900.0, 3000.0}) {
            look(irsg, {30, 15}, range_m);
            const Sampled both = sampled(irsg, sampledFrom_m);
            const std::string name =
                std::to_string(sampledFrom_m) + " to " + std::to_string(range_m);
            EXPECT_GT(both.fromOne.alongRangeReach_m, 0.0) << name;
            EXPECT_LT(both.fromOne.alongRangeReach_m, 10.0) << name;
            EXPECT_LT(std::abs(both.off()), both.error() + 1e-3) << name;
            if (range_m == sampledFrom_m) {
                EXPECT_LT(std::abs(both.off()), 1e-3) << name;
            }
            const ObjectRadiometry& all = both.drawn.all;
            backgrounds.push_back((all.intensity_W_sr - all.contrastIntensity_W_sr) /
                                  all.solidAngle_sr / (range_m * range_m));
        }
    }
    const auto [least, most] = std::ranges::minmax_element(backgrounds);
    EXPECT_GT(*most, 1.1 * *least) << "the squares matter";
}

// A wall just before the target hides its lower part from any range alike.
TEST(RangeCurve, FromOneDrawingIsHiddenByTheTerrainAroundIt) {
    InteractiveRenderer irsg = boxOverGround({{{-30, 8, -40}, {60, 0, 0}, {0, 0, 40.2}, 4}});
    for (const double range_m : {300.0, 3000.0}) {
        look(irsg, {0, 2}, range_m);
        const double whole_sr = [&] {
            irsg.scene.settings.terrainHides = false;
            const double seen_sr = irsg.measure().all.solidAngle_sr;
            irsg.scene.settings.terrainHides = true;
            return seen_sr;
        }();
        for (const double sampledFrom_m : {300.0, 3000.0}) {
            const Sampled both = sampled(irsg, sampledFrom_m);
            const std::string name =
                std::to_string(sampledFrom_m) + " to " + std::to_string(range_m);
            EXPECT_GT(both.fromOne.alongRangeReach_m, 7.0) << name;
            EXPECT_LT(both.drawn.all.solidAngle_sr, 0.8 * whole_sr) << name;
            EXPECT_GT(both.drawn.all.solidAngle_sr, 0.1 * whole_sr) << name;
            EXPECT_LT(std::abs(both.off()), both.error() + 2e-3) << name;
            if (range_m == sampledFrom_m) {
                EXPECT_LT(std::abs(both.off()), 2e-3) << name;
            }
        }
    }
}

// A wall far before the target is behind a camera that is nearer.
TEST(RangeCurve, IsDrawnForItselfWhereTerrainStandsFarBeforeTheTarget) {
    InteractiveRenderer irsg = boxOverGround({{{-300, 200, -40}, {600, 0, 0}, {0, 0, 400}, 4}});
    for (const auto& [range_m, sampledFrom_m] :
         {std::pair{150.0, 3000.0}, {150.0, 6000.0}, {3000.0, 150.0}, {6000.0, 150.0}}) {
        look(irsg, {0, 5}, range_m);
        const Sampled both = sampled(irsg, sampledFrom_m);
        EXPECT_EQ(both.fromOne.alongRangeReach_m, 0.0) << range_m;
        // With errors the samples are added up in another order.
        EXPECT_NEAR(both.fromOne.all.contrastIntensity_W_sr, both.drawn.all.contrastIntensity_W_sr,
                    1e-9 * both.drawn.all.intensity_W_sr)
            << range_m;
        EXPECT_EQ(both.drawn.all.contrastIntensity_W_sr == 0.0, range_m > 200.0) << range_m;
    }
}
