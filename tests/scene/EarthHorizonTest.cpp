// What the earth's curve hides of objects, part by part.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/render/rays/RaysBuilt.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};
constexpr double sensor_m = 10.0, height_m = 20.0;

/// Nothing but the earth's curve.
class BareEarth : public ConstantAtmosphere {
  public:
    TargetView targetView(const AtmosphericPath& path) const override {
        return sphericalTargetView(path);
    }
};

/// And air that is asked for its temperature.
class EarthWithAir : public BareEarth {
  public:
    double ambientTemperature_K(double altitude_m) const override {
        altitudes_m.push_back(altitude_m);
        return 288.15;
    }
    mutable std::vector<double> altitudes_m;
};

/// A wall of 100 m that stands on the sea, seen over a range from 10 m above it.
class HullDown : public ::testing::TestWithParam<EngineChoice> {
  protected:
    void SetUp() override {
        if (GetParam() == EngineChoice::rays && !areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
        RenderSettings settings = RenderSettings::direct();
        settings.engine = GetParam();
        settings.sun = settings.ambientReflection = ReflectionMode::off;
        irsg.scene.settings = settings;
        irsg.scene.environment = Environment();
        irsg.scene.environment.add(std::make_shared<BareEarth>());
        Entity wall = entityOf(
            modelOf(plateMesh({0, 0, 0.5 * height_m}, {50, 0, 0}, {0, 0, 0.5 * height_m}, one)),
            greyDatabase(1.0, 300.0));
        wall.pose.position_m = {};
        irsg.scene.entities = {wall};
    }
    RenderReport from(double range_m, int side_px = 200) {
        irsg.view.sensor = {.width_px = side_px,
                            .height_px = side_px,
                            .horizontalFieldOfView_rad = 150.0 / range_m,
                            .band = Band::topHat(8.0, 12.0)};
        irsg.view.viewpoint = Viewpoint::lookAt({0, -range_m, sensor_m}, {0, 0, 0.5 * height_m});
        return irsg.measure();
    }

    InteractiveRenderer irsg;
};

} // namespace

TEST_P(HullDown, ShowsThePartThatStandsAboveTheHorizon) {
    const double whole_W_sr = from(5e3).all.intensity_W_sr;
    for (const double range_m : {11e3, 13e3, 16e3, 20e3, 24e3, 27e3}) {
        const double hidden_m =
            sphericalTargetView({sensor_m, 0.5 * height_m, range_m, 0.0}).hiddenBelow_m;
        const double expected = 1.0 - std::min(hidden_m / height_m, 1.0);
        const RenderReport seen = from(range_m);
        EXPECT_NEAR(seen.all.intensity_W_sr / whole_W_sr, expected, 4e-3) << range_m;
        EXPECT_NEAR(seen.objects.front().hiddenByHorizon, 1.0 - expected, 1e-5) << range_m;
    }
}

TEST_P(HullDown, VanishesContinuously) {
    const double whole_W_sr = from(5e3).all.intensity_W_sr;
    double before = 1.0;
    for (double range_m = 10.5e3; range_m <= 28e3; range_m += 500.0) {
        const double part = from(range_m).all.intensity_W_sr / whole_W_sr;
        EXPECT_LE(part, before + 3e-3) << range_m;
        EXPECT_LT(before - part, 0.08) << range_m;
        before = part;
    }
    EXPECT_EQ(before, 0.0);
}

TEST_P(HullDown, IsGoneBehindTheHorizonAtAnyRange) {
    for (const double range_m : {40e3, 150e3, 1e6}) {
        const RenderReport report = from(range_m);
        EXPECT_EQ(report.all.intensity_W_sr, 0.0) << range_m;
        EXPECT_EQ(report.all.contrastIntensity_W_sr, 0.0) << range_m;
    }
}

TEST_P(HullDown, IsSaidInTheReport) {
    const auto says = [](const RenderReport& report, const std::string& words) {
        return std::ranges::any_of(report.warnings, [&](const std::string& warning) {
            return warning.find(words) != std::string::npos;
        });
    };
    EXPECT_FALSE(says(from(5e3), "horizon"));
    EXPECT_TRUE(says(from(20e3), "is partly behind the horizon"));
    EXPECT_TRUE(says(from(40e3), "is behind the horizon"));
}

// Its surfaces go with the air about it, wherever they would appear.
TEST_P(HullDown, KeepsTheAirOfItsOwnAltitude) {
    const auto earth = std::make_shared<EarthWithAir>();
    irsg.scene.environment = Environment();
    irsg.scene.environment.add(earth);
    for (const double range_m : {5e3, 20e3, 600e3}) {
        from(range_m);
    }
    ASSERT_FALSE(earth->altitudes_m.empty());
    EXPECT_EQ(std::ranges::max(earth->altitudes_m), 0.0) << "of the wall's foot";
}

TEST_P(HullDown, HidesNothingOfWhatIsNearer) {
    const double alone_W_sr = from(20e3).all.intensity_W_sr;
    Entity buoy = entityOf(modelOf(plateMesh({0, 0, 0}, {2, 0, 0}, {0, 0, 2}, one)),
                           greyDatabase(1.0, 300.0));
    buoy.pose.position_m = {0, -12e3, 10.0};
    irsg.scene.entities.push_back(buoy);
    const RenderReport both = from(20e3);
    EXPECT_GT(both.objects[1].intensity_W_sr, 0.0);
    EXPECT_LT(both.objects[0].intensity_W_sr, alone_W_sr) << "the buoy stands before it";
}

TEST_P(HullDown, AppliesToPointsBelowAPixel) {
    const double whole_W_sr = from(5e3).all.intensity_W_sr;
    irsg.view.sensor.width_px = irsg.view.sensor.height_px = 1;
    const double hidden_m =
        sphericalTargetView({sensor_m, 0.5 * height_m, 20e3, 0.0}).hiddenBelow_m;
    irsg.view.sensor.horizontalFieldOfView_rad = 2.0;
    irsg.view.viewpoint = Viewpoint::lookAt({0, -20e3, sensor_m}, {0, 0, 0.5 * height_m});
    EXPECT_NEAR(irsg.measure().all.intensity_W_sr / whole_W_sr, 1.0 - hidden_m / height_m, 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Engines, HullDown,
                         ::testing::Values(EngineChoice::opengl, EngineChoice::rays),
                         [](const auto& engine) {
                             return engine.param == EngineChoice::rays ? "Rays" : "OpenGl";
                         });
