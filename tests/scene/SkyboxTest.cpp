#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "irsg/radiometry/Units.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/TerrainPass.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// What the pictures of the faces show at -1 to 1 to the right and downwards, by the words of
/// Skybox.h.
Vec3 faceDirection(std::size_t face, double right, double down) {
    switch (face) {
    case 0:
        return {right, 1, -down};
    case 1:
        return {-right, -1, -down};
    case 2:
        return {1, -right, -down};
    case 3:
        return {-1, right, -down};
    case 4:
        return {right, down, 1};
    default:
        return {right, -down, -1};
    }
}

/// Six faces painted with a function of direction.
std::array<TextureImage, 6> painted(int size, const std::function<double(const Vec3&)>& colour) {
    std::array<TextureImage, 6> faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face].width_px = faces[face].height_px = size;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                faces[face].values.push_back(static_cast<float>(colour(normalized(faceDirection(
                    face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0)))));
            }
        }
    }
    return faces;
}

std::array<TextureImage, 6> plain(int size, float value) {
    return painted(size, [&](const Vec3&) { return static_cast<double>(value); });
}

double smooth(const Vec3& d) {
    return 2.0 + d.x + 0.5 * d.y * d.z - 0.7 * d.z * d.z;
}

Viewpoint looking(double azimuth_deg, double elevation_deg, const Vec3& eye = {}) {
    return Viewpoint::lookAt(eye, eye + direction(radians(azimuth_deg), radians(elevation_deg)));
}

FrameBackground drawn(SceneBackground& background, const Sensor& sensor, const Viewpoint& view,
                      const BackgroundSettings& settings, BackgroundReport& report) {
    ConstantAtmosphere air;
    air.sunValue = 5.0;
    const Environment environment = environmentOf(air, {0.0, 0.1});
    const SpectralPoints ends({3.0, 5.0}, {1.0, 1.0}, {3.0, 5.0});
    const BandSky sky(environment, ends);
    GlTerrain painter;
    return background.draw(sensor, view, sky, settings, painter, report);
}

} // namespace

TEST(TextureScale, AddsNothingAtTheOffsetAndTheSlopeFromBlackToWhite) {
    const TextureScale scale{7.5, 128.0 / 255.0};
    const float grey = 128.0f / 255.0f;
    EXPECT_EQ(scale.radiance_W_m2_sr(static_cast<double>(grey)), 0.0);
    EXPECT_DOUBLE_EQ(scale.radiance_W_m2_sr(1.0) - scale.radiance_W_m2_sr(0.0), 7.5);
}

TEST(Skybox, CarriesOneValueUnchangedAtEveryScale) {
    const Skybox sky(plain(37, 123.25f));
    for (const double fieldOfView_deg : {0.01, 20.0, 150.0}) {
        for (const double elevation_deg : {0.0, 40.0, -90.0}) {
            const FieldRays rays(sensorOf(31, 17, fieldOfView_deg), looking(33.0, elevation_deg));
            for (const double value : sky.pixels(rays, {})) {
                EXPECT_EQ(value, 123.25);
            }
        }
    }
}

TEST(Skybox, AddsExactlyNothingWhereAllIsOffsetGrey) {
    const Skybox sky(plain(16, 128.0f / 255.0f));
    const FieldRays rays(sensorOf(31, 17, 90.0), looking(45.0, 35.0));
    for (const double value : sky.pixels(rays, {50.0, 128.0 / 255.0})) {
        EXPECT_EQ(value, 0.0);
    }
}

TEST(Skybox, ShowsEachFaceWhereItBelongs) {
    std::array<TextureImage, 6> faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face] = {2, 2, std::vector<float>(4, static_cast<float>(face + 1))};
    }
    const Skybox sky(faces);
    EXPECT_EQ(sky.at({0, 1, 0}), 1.0) << "north is +y";
    EXPECT_EQ(sky.at({0, -1, 0}), 2.0);
    EXPECT_EQ(sky.at({1, 0, 0}), 3.0) << "east is +x";
    EXPECT_EQ(sky.at({-1, 0, 0}), 4.0);
    EXPECT_EQ(sky.at({0, 0, 1}), 5.0);
    EXPECT_EQ(sky.at({0, 0, -1}), 6.0);
}

TEST(Skybox, IsContinuousAndCloseToWhatWasPaintedOverEdgesAndCorners) {
    constexpr int size = 64;
    const Skybox sky(painted(size, smooth));
    double worst = 0.0, jump = 0.0;
    const auto walk = [&](const Vec3& from, const Vec3& to) {
        double before = sky.at(from);
        constexpr int steps = 20000;
        for (int i = 1; i <= steps; ++i) {
            const Vec3 d = from + (to - from) * (static_cast<double>(i) / steps);
            const double value = sky.at(d);
            worst = std::max(worst, std::abs(value - smooth(normalized(d))));
            jump = std::max(jump, std::abs(value - before));
            before = value;
        }
    };
    // Over every edge, once obliquely, and through every corner.
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            walk({x, 0.3, 0.2}, {0.1, y, -0.4});
            walk({x, 0.3, 0.2 * y}, {0.3 * y, 0.1, x});
            walk({0.3, x, 0.2 * y}, {0.2 * y, 0.1, x});
            for (const double z : {-1.0, 1.0}) {
                walk({x, 0.9 * y, 0.95 * z}, {0.9 * x, 1.05 * y, 1.02 * z});
                walk({x, 0.99 * y, 0.98 * z}, {0.97 * x, 0.98 * y, z});
            }
        }
    }
    EXPECT_LT(worst, 6e-3) << "a texel is 1.8 degrees, over which the function changes by 0.06";
    EXPECT_LT(jump, 5e-4) << "a step is 1e-4";
}

TEST(Skybox, AveragesTexelsThatAreSmallerThanPixels) {
    // A chessboard of single texels is grey from afar, to within the contrast of a few faces' rims.
    constexpr int size = 256;
    std::array<TextureImage, 6> faces;
    for (TextureImage& face : faces) {
        face.width_px = face.height_px = size;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                face.values.push_back((x + y) % 2 ? 1.0f : 0.0f);
            }
        }
    }
    const Skybox sky(faces);
    const FieldRays coarse(sensorOf(24, 24, 90.0), looking(20.0, 10.0));
    for (const double value : sky.pixels(coarse, {})) {
        EXPECT_NEAR(value, 0.5, 0.01);
    }
    const FieldRays fine(sensorOf(64, 64, 0.5), looking(20.0, 10.0));
    const std::vector<double> seen = sky.pixels(fine, {});
    EXPECT_GT(*std::ranges::max_element(seen), 0.9);
    EXPECT_LT(*std::ranges::min_element(seen), 0.1);
}

TEST(Skybox, KeepsTheMeanOfAFunctionInCoarsePixels) {
    const Skybox sky(
        painted(150, [](const Vec3& d) { return smooth(d) + 0.3 * std::sin(300.0 * d.x); }));
    const FieldRays rays(sensorOf(9, 9, 80.0), looking(10.0, 5.0));
    const std::vector<double> pixels = sky.pixels(rays, {});
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
            double mean = 0.0;
            constexpr int n = 40;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    mean += sky.at(rays.at(rays.u(x + (i + 0.5) / n), rays.v(y + (j + 0.5) / n)));
                }
            }
            EXPECT_NEAR(pixels[static_cast<std::size_t>(y * 9 + x)], mean / (n * n), 0.05);
        }
    }
}

TEST(Skybox, FollowsTheEyeAndTurnsWithTheView) {
    SceneBackground background;
    background.setSkybox(std::make_shared<const Skybox>(painted(32, smooth)));
    const Sensor sensor = sensorOf(40, 30, 50.0);
    BackgroundSettings settings;
    settings.skybox = {2.0, 0.5};
    BackgroundReport report;
    const auto here = drawn(background, sensor, looking(10, 5), settings, report);
    const auto there =
        drawn(background, sensor, looking(10, 5, {3e5, -2e5, 1000.0}), settings, report);
    const auto turned = drawn(background, sensor, looking(60, 5), settings, report);
    double difference = 0.0;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            EXPECT_NEAR(there.at(x, y), here.at(x, y), 1e-9);
            difference = std::max(difference, std::abs(turned.at(x, y) - here.at(x, y)));
        }
    }
    EXPECT_GT(difference, 0.5);
    const FieldRays rays(sensor, looking(10, 5));
    EXPECT_NEAR(here.at(0, 0), 2.0 * (smooth(normalized(rays.at(rays.u(0.5), rays.v(0.5)))) - 0.5),
                0.01);
}

TEST(SceneBackground, AddsItsLayersAndFloorsAndCountsWhatIsBelowZero) {
    SceneBackground background;
    background.setSkybox(std::make_shared<const Skybox>(painted(64, smooth)));
    const Sensor sensor = sensorOf(40, 30, 8.0);
    const Viewpoint view = looking(0.0, degrees(0.1));
    BackgroundSettings settings;
    settings.queriesEnvironment = false;
    settings.uniform_W_m2_sr = 0.25;
    settings.sunDisc = true;
    settings.skybox = {10.0, 2.05};
    BackgroundReport report;
    const FrameBackground frame = drawn(background, sensor, view, settings, report);
    const std::vector<double> sky = background.layers().sky;

    // The sun replaces the skybox behind it, and the uniform background is added upon both.
    settings.sunDisc = false;
    BackgroundReport without;
    drawn(background, sensor, view, settings, without);
    const std::vector<double> skybox = background.layers().sky;
    long below = 0;
    double sunInside = 0.0;
    const std::size_t middle = 15 * 40 + 20;
    for (std::size_t i = 0; i < sky.size(); ++i) {
        const double sum = sky[i] + 0.25;
        below += sum < 0.0;
        EXPECT_DOUBLE_EQ(frame.at(static_cast<int>(i % 40), static_cast<int>(i / 40)),
                         std::max(sum, 0.0));
        sunInside = std::max(sunInside, sky[i]);
    }
    EXPECT_GT(below, 100);
    EXPECT_EQ(report.flooredPixels, below);
    EXPECT_NEAR(sky[middle], 10.0 / 6.72e-5, 0.01 * 10.0 / 6.72e-5) << "nothing of the skybox";
    EXPECT_NE(skybox[middle], sky[middle]);
    EXPECT_EQ(skybox[0], sky[0]);
}

TEST(SceneBackground, WarnsOfASunInTheSkyboxWhereTheDiscIsOn) {
    const auto withSpot = [](double radius_deg, double others) {
        return std::make_shared<const Skybox>(painted(512, [=](const Vec3& d) {
            const double cosine = dot(d, direction(1.0, 0.5));
            return cosine > std::cos(radians(radius_deg)) ? 1.0
                   : d.x < -0.8                           ? others
                                                          : 0.2 + 0.05 * d.z;
        }));
    };
    EXPECT_TRUE(withSpot(0.3, 0.2)->brightSpot_rad());
    EXPECT_FALSE(withSpot(2.0, 0.2)->brightSpot_rad()) << "too large";
    EXPECT_FALSE(withSpot(0.3, 0.9)->brightSpot_rad()) << "other things are as bright";
    EXPECT_FALSE(Skybox(plain(64, 0.5f)).brightSpot_rad());

    SceneBackground background;
    background.setSkybox(withSpot(0.3, 0.2));
    BackgroundSettings settings;
    BackgroundReport off, on;
    drawn(background, sensorOf(8, 8, 5.0), looking(0, 0), settings, off);
    EXPECT_TRUE(off.warnings.empty());
    settings.sunDisc = true;
    drawn(background, sensorOf(8, 8, 5.0), looking(0, 0), settings, on);
    ASSERT_EQ(on.warnings.size(), 1u);
    EXPECT_NE(on.warnings[0].find("bright spot"), std::string::npos);
}
