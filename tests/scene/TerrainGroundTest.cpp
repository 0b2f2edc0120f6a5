#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "irsg/radiometry/Units.h"
#include "irsg/render/background/BackgroundGrid.h"
#include "irsg/render/background/GroundDistance.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/TerrainPass.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/TerrainSheets.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr double eye_m = 400.0;

/// Air whose ground grows brighter towards the horizon, in front of a far brighter sky.
class StepAtHorizon : public ConstantAtmosphere {
  public:
    explicit StepAtHorizon(double horizon_rad) : horizon_rad_(horizon_rad) {}
    double horizonElevation_rad(double) const override { return horizon_rad_; }
    static double ofGround(double below_rad) { return 1.0 - 0.5 * std::sin(below_rad); }
    static constexpr double ofSky = 3.0;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override {
        ConstantAtmosphere same;
        const double above_rad = query.sight.elevation_rad - horizon_rad_;
        same.backgroundValue = above_rad < 0.0 ? ofGround(-above_rad) : ofSky;
        return same.spectrum(query, range);
    }

  private:
    double horizon_rad_;
};

/// A rectangle without a texture, which adds nothing.
std::shared_ptr<const Terrain> sheet(const Vec3& corner, const Vec3& along, const Vec3& up) {
    return terrainOfGraph(*test::sheet(corner, along, up, {}), "sheet");
}

/// Looks north, level, 12 degrees high.
FrameBackground picture(const std::shared_ptr<const Terrain>& terrain, double horizon_rad,
                        TerrainPainter& painter, int rows = 0, int columns = 1) {
    Environment environment;
    environment.add(std::make_shared<StepAtHorizon>(horizon_rad));
    const SpectralPoints ends({3.0, 4.0}, {0.5, 0.5}, {3.0, 4.0});
    const BandSky sky(environment, ends);
    SceneBackground background;
    background.setTerrain(terrain);
    BackgroundSettings settings;
    settings.rows = rows;
    settings.columns = columns;
    BackgroundReport report;
    const Viewpoint view = Viewpoint::lookAt({0, 0, eye_m}, {0, 1, eye_m});
    return background.draw(sensorOf(120, 120, 12.0), view, sky, settings, painter, report);
}

class TerrainIsGround : public ::testing::TestWithParam<EngineChoice> {
  protected:
    void SetUp() override {
        if (GetParam() == EngineChoice::rays && !areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
        if (GetParam() == EngineChoice::rays) {
            painter = std::make_unique<TerrainRays>();
        } else {
            painter = std::make_unique<GlTerrain>();
        }
    }
    std::unique_ptr<TerrainPainter> painter;
};

} // namespace

TEST(GroundDistance, IsThatOfASphereWhoseHorizonDipsAsFar) {
    constexpr double radius_m = 6371.23e3;
    for (const double height_m : {2.0, 405.0, 11e3}) {
        const double dip_rad = std::acos(radius_m / (radius_m + height_m));
        const GroundDistance ground(height_m, -dip_rad);
        // A point of the sphere at an angle of the centre from below the sensor.
        for (const double part : {0.001, 0.1, 0.5, 0.9}) {
            const double turn_rad = part * dip_rad;
            const double across_m = radius_m * std::sin(turn_rad);
            const double down_m =
                height_m + 2.0 * radius_m * std::pow(std::sin(0.5 * turn_rad), 2.0);
            EXPECT_NEAR(ground.belowHorizon_rad(std::hypot(across_m, down_m)),
                        std::atan2(down_m, across_m) - dip_rad, 1e-7)
                << height_m << " m, " << part;
        }
        const double horizon_m = (radius_m + height_m) * std::sin(dip_rad);
        EXPECT_EQ(ground.belowHorizon_rad(1.001 * horizon_m), 0.0);
        EXPECT_NEAR(ground.belowHorizon_rad(0.5 * height_m), 0.5 * pi - dip_rad, 1e-12)
            << "nearer than any ground: straight down";
    }
}

TEST(GroundDistance, IsThatOfAPlaneWhereTheHorizonDoesNotDip) {
    const GroundDistance ground(100.0, 0.0);
    EXPECT_NEAR(ground.belowHorizon_rad(200.0), radians(30.0), 1e-12);
    EXPECT_NEAR(ground.belowHorizon_rad(1e9), 1e-7, 1e-12);
    EXPECT_NEAR(ground.belowHorizon_rad(100.0), 0.5 * pi, 1e-6);
    EXPECT_EQ(GroundDistance(0.0, 0.0).belowHorizon_rad(5.0), 0.0) << "on the ground";
}

TEST_P(TerrainIsGround, LevelTerrainThatAddsNothingIsTheGroundOfTheAir) {
    // A plane at altitude 0, seen from 400 m over flat air: below the horizon nothing may change.
    const auto plain = sheet({-50e3, 100, 0}, {100e3, 0, 0}, {0, 400e3, 0});
    const FrameBackground bare = picture(nullptr, 0.0, *painter);
    const FrameBackground covered = picture(plain, 0.0, *painter);
    for (int y = 0; y < 120; ++y) {
        // The pixel of the plane's far edge, 0.06 degrees below the horizon, has both.
        if (y < 59 || y > 61) {
            EXPECT_NEAR(covered.at(60, y) / bare.at(60, y), 1.0, 0.5 * BackgroundGrid::needed) << y;
        }
    }
}

TEST_P(TerrainIsGround, AWallAcrossTheHorizonHasNoSeamThere) {
    // 2 km away: from far below to far above the horizon, over the right half.
    const auto wall = sheet({0, 2000, 0}, {2000, 0, 0}, {0, 0, 2000});
    for (const double horizon_rad : {0.0, -0.0112}) {
        for (const int rows : {0, 16}) {
            for (const int columns : {1, 3}) {
                const FrameBackground seen = picture(wall, horizon_rad, *painter, rows, columns);
                const GroundDistance ground(eye_m, horizon_rad);
                for (int y = 0; y < 120; ++y) {
                    if (y < 59) {
                        EXPECT_NEAR(seen.at(20, y), StepAtHorizon::ofSky, 1e-9) << "beside it";
                    }
                    const double down = std::tan(radians(6.0)) * (y - 59.5) / 60.0;
                    const double across = std::tan(radians(6.0)) * (100 - 59.5) / 60.0;
                    const double distance_m = 2000.0 * std::hypot(1.0, down, across);
                    const double expected =
                        StepAtHorizon::ofGround(ground.belowHorizon_rad(distance_m));
                    EXPECT_NEAR(seen.at(100, y), expected, 2e-3) << y << ", rows " << rows;
                    if (y > 0) {
                        EXPECT_NEAR(seen.at(100, y), seen.at(100, y - 1), 1e-3) << y;
                    }
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Painters, TerrainIsGround,
                         ::testing::Values(EngineChoice::opengl, EngineChoice::rays),
                         [](const auto& instance) {
                             return instance.param == EngineChoice::rays ? "Rays" : "OpenGL";
                         });
