#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/radiometry/Units.h"
#include "irsg/render/background/CircleArea.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/SunDisc.h"
#include "irsg/render/background/TerrainPass.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr double irradiance_W_m2 = 20.0;
constexpr double belowEverything_rad = -0.5 * pi;

/// A camera looking horizontally north, turned by small angles to move the sun over the pixels.
Viewpoint looking(double azimuth_rad, double elevation_rad) {
    return Viewpoint::lookAt({0, 0, 0}, direction(azimuth_rad, elevation_rad));
}

Sensor sensorWithDiscOf(double pixels, int side_px) {
    Sensor sensor;
    sensor.width_px = sensor.height_px = side_px;
    const double pitch = 2.0 * std::tan(0.5 * SunDisc::diameter_rad) / pixels;
    sensor.horizontalFieldOfView_rad = 2.0 * std::atan(0.5 * pitch * side_px);
    return sensor;
}

double sumOver(const Sensor& sensor, const SunDisc& disc) {
    double sum = 0.0;
    for (const SunDisc::Pixel& pixel : disc.pixels()) {
        sum += disc.radiance_W_m2_sr(irradiance_W_m2) * pixel.coverage *
               sensor.pixelSolidAngle_sr(pixel.x, pixel.y);
    }
    return sum;
}

} // namespace

TEST(CircleArea, IsThatOfTheCircleThePolygonAndTheirOverlap) {
    const std::array<PlanePoint, 4> around{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};
    EXPECT_NEAR(areaInUnitCircle(around), pi, 1e-14);
    const std::array<PlanePoint, 4> inside{{{0.1, 0.1}, {0.5, 0.1}, {0.5, 0.3}, {0.1, 0.3}}};
    EXPECT_NEAR(areaInUnitCircle(inside), 0.08, 1e-15);
    const std::array<PlanePoint, 4> quarter{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
    EXPECT_NEAR(areaInUnitCircle(quarter), pi / 4.0, 1e-14);
    const std::array<PlanePoint, 4> outside{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
    EXPECT_NEAR(areaInUnitCircle(outside), 0.0, 1e-14);
    // A circular segment of height 1 - d has the area acos(d) - d sqrt(1 - d^2).
    const double d = 0.3;
    const std::array<PlanePoint, 4> cap{{{d, -2}, {3, -2}, {3, 2}, {d, 2}}};
    EXPECT_NEAR(areaInUnitCircle(cap), std::acos(d) - d * std::sqrt(1 - d * d), 1e-14);
}

TEST(SunDisc, SumsToTheIrradianceAtEverySizeAndPixelPhase) {
    double worst = 0.0;
    for (const double size : {0.1, 0.3, 1.0, 2.5, 7.0, 20.0, 50.0, 80.0}) {
        const Sensor sensor = sensorWithDiscOf(size, size > 10 ? 120 : 24);
        const FieldRays rays(sensor, looking(0, 0));
        for (int i = 0; i < 16; ++i) {
            for (int j = 0; j < 16; ++j) {
                const double u = (i / 16.0 + 0.013) * rays.pitch, v = (j / 16.0) * rays.pitch;
                const SunDisc disc(rays, Horizon(rays, belowEverything_rad),
                                   normalized(rays.at(u, v)));
                worst = std::max(worst, std::abs(sumOver(sensor, disc) / irradiance_W_m2 - 1.0));
            }
        }
    }
    EXPECT_LT(worst, 1e-6);
    RecordProperty("largest_relative_error", std::to_string(worst));
}

TEST(SunDisc, HasTheRadianceOfItsSolidAngleWhereverItIsInAWideField) {
    Sensor sensor;
    sensor.width_px = 640, sensor.height_px = 512;
    sensor.horizontalFieldOfView_rad = radians(80.0);
    const double exact = irradiance_W_m2 / (2.0 * pi * (1.0 - std::cos(radians(0.265))));
    EXPECT_NEAR(irradiance_W_m2 / 6.72e-5 / exact, 1.0, 2e-4);
    for (const double off_deg : {0.0, 10.0, 30.0, 38.0}) {
        const FieldRays rays(sensor, looking(radians(off_deg), 0.1));
        const SunDisc disc(rays, Horizon(rays, belowEverything_rad), direction(0.0, 0.05));
        ASSERT_FALSE(disc.pixels().empty()) << off_deg;
        EXPECT_NEAR(disc.radiance_W_m2_sr(irradiance_W_m2) / exact, 1.0, 1e-4) << off_deg;
        EXPECT_NEAR(sumOver(sensor, disc) / irradiance_W_m2, 1.0, 1e-12) << off_deg;
        const auto fullest = std::ranges::max_element(disc.pixels(), {}, &SunDisc::Pixel::coverage);
        EXPECT_EQ(fullest->coverage, 1.0) << off_deg;
    }
}

TEST(SunDisc, IsCutByTheFrameAndGoneBehindTheCamera) {
    const Sensor sensor = sensorWithDiscOf(10.0, 64);
    const FieldRays rays(sensor, looking(0, 0));
    const Horizon horizon(rays, belowEverything_rad);
    const SunDisc whole(rays, horizon, direction(0, 0));
    const SunDisc onEdge(rays, horizon, normalized(rays.at(rays.uLimit(), 0.0)));
    EXPECT_NEAR(sumOver(sensor, onEdge) / sumOver(sensor, whole), 0.5, 1e-3);
    EXPECT_NEAR(onEdge.radiance_W_m2_sr(1.0) / whole.radiance_W_m2_sr(1.0), 1.0, 1e-5);
    EXPECT_TRUE(SunDisc(rays, horizon, direction(pi, 0)).pixels().empty());
    EXPECT_TRUE(SunDisc(rays, horizon, direction(0.5 * pi, 0)).pixels().empty());
}

TEST(SunDisc, IsHalfOnTheHorizonWhereItsCentreIs) {
    for (const double size : {0.4, 3.0, 40.0, 90.0}) {
        const Sensor sensor = sensorWithDiscOf(size, size > 10 ? 160 : 25);
        const FieldRays rays(sensor, looking(0.0, 0.0013));
        const SunDisc whole(rays, Horizon(rays, belowEverything_rad), direction(0, 0.001));
        const SunDisc half(rays, Horizon(rays, 0.001), direction(0, 0.001));
        EXPECT_NEAR(sumOver(sensor, half) / sumOver(sensor, whole), 0.5, 1e-4) << size;
        const SunDisc set(rays, Horizon(rays, 0.001), direction(0, 0.001 - radians(0.27)));
        EXPECT_TRUE(set.pixels().empty()) << size;
    }
}

TEST(SunDisc, IsInThePictureOnlyWhereItIsAskedFor) {
    ConstantAtmosphere air;
    air.sunValue = 5.0;
    air.backgroundValue = 3.0;
    const Environment environment = environmentOf(air, {0.3, 0.2});
    const SpectralPoints ends({3.0, 5.0}, {1.0, 1.0}, {3.0, 5.0});
    const BandSky sky(environment, ends);
    const Sensor sensor = sensorWithDiscOf(5.0, 32);
    Viewpoint view = looking(0.3, 0.2);

    SceneBackground background;
    GlTerrain painter;
    BackgroundSettings settings;
    settings.uniform_W_m2_sr = 6.0;
    BackgroundReport report;
    EXPECT_TRUE(background.draw(sensor, view, sky, settings, painter, report).isUniform());

    settings.sunDisc = true;
    const FrameBackground frame = background.draw(sensor, view, sky, settings, painter, report);
    ASSERT_FALSE(frame.isUniform());
    double sum = 0.0;
    for (int y = 0; y < sensor.height_px; ++y) {
        for (int x = 0; x < sensor.width_px; ++x) {
            sum += (frame.at(x, y) - 6.0) * sensor.pixelSolidAngle_sr(x, y);
        }
    }
    EXPECT_NEAR(sum, 10.0, 1e-9) << "E over the band, upon the background";
    EXPECT_EQ(frame.at(0, 0), 6.0);
    EXPECT_EQ(report.providedBy, std::vector<std::string>{"solar disc: constant air"});

    // It follows the eye, and turns with the view.
    view.position_m = {1e5, -3e4, 0.0};
    const FrameBackground moved = background.draw(sensor, view, sky, settings, painter, report);
    for (int i = 0; i < sensor.width_px; ++i) {
        EXPECT_EQ(moved.at(i, i), frame.at(i, i));
    }
    EXPECT_TRUE(background.draw(sensor, looking(0.3 + pi, 0.2), sky, settings, painter, report)
                    .isUniform());
}
