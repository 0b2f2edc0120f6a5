// Objects far from the axis of a frame have the solid angle and the cosine of their own place, also
// where they are smaller than a pixel.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/image/ImageIntensity.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};
constexpr double emissivity = 0.9, temperature_K = 320.0;

struct Case {
    std::string name;
    double diameter_px, offAxis_deg;
    double pointSourceBelow_px = 0.0;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class OffAxisSphere : public testing::TestWithParam<Case> {};

} // namespace

TEST_P(OffAxisSphere, HasTheIntensityAndIrradianceOfItsPlaceInAllPhases) {
    const Case& c = GetParam();
    constexpr int side_px = 128;
    constexpr double range_m = 1000.0;
    InteractiveRenderer irsg;
    irsg.scene.settings.bounces = 0;
    irsg.scene.settings.pointSourceBelow_px = c.pointSourceBelow_px;
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    constexpr double pitch = 2.0 / side_px;
    const double tangent = std::tan(radians(c.offAxis_deg));
    const double slant_rad = std::atan(tangent);
    const double radius_m =
        0.5 * c.diameter_px * pitch * std::cos(slant_rad) * std::cos(slant_rad) * range_m;
    const Triangles mesh = sphereMesh(radius_m, 48, 96, one);
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(emissivity, temperature_K))};
    look(irsg, {.range_m = range_m,
                .width_px = side_px,
                .height_px = side_px,
                .fieldOfView_rad = radians(90.0)});
    const Viewpoint camera = irsg.view.viewpoint;
    const double radiance =
        emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);

    double worst = 0.0, worstIrradiance = 0.0;
    for (int phase = 0; phase < 24; ++phase) {
        const double azimuth_rad = 0.37 + 1.7 * phase;
        const double u = tangent * std::cos(azimuth_rad) + pitch * std::fmod(0.618034 * phase, 1.0);
        const double v = tangent * std::sin(azimuth_rad) + pitch * std::fmod(0.414214 * phase, 1.0);
        const Vec3 towards = normalized(camera.forward() + camera.right * u + camera.up * v);
        Pose pose{camera.position_m + towards * range_m, {}};
        irsg.scene.entities[0].pose = pose;
        const Vec3 from = camera.position_m - pose.position_m;
        const double solidAngle_sr = convexSolidAngle_sr(mesh, from);

        const RenderedImage seen = irsg.imageWithReport();
        const ObjectRadiometry& printed = seen.report.all;
        const double truth_W_sr = radiance * solidAngle_sr * dot(from, from);
        const double truth_W_m2 = radiance * solidAngle_sr * dot(towards, camera.forward());
        worst = std::max(worst, std::abs(printed.intensity_W_sr / truth_W_sr - 1.0));
        worstIrradiance =
            std::max(worstIrradiance, std::abs(printed.irradiance_W_m2 / truth_W_m2 - 1.0));
        EXPECT_NEAR(contrastIntensity_W_sr(seen.image, seen.image.primary()).value(),
                    printed.contrastIntensity_W_sr, 2e-5 * printed.intensity_W_sr);
        const ObjectRadiometry swept = irsg.measure().all;
        EXPECT_NEAR(swept.intensity_W_sr, printed.intensity_W_sr, 1e-6 * printed.intensity_W_sr);
        EXPECT_NEAR(swept.irradiance_W_m2, printed.irradiance_W_m2, 1e-6 * printed.irradiance_W_m2);
    }
    std::printf("%s: intensity off by up to %.2e, irradiance by %.2e\n", c.name.c_str(), worst,
                worstIrradiance);
    EXPECT_LT(worst, 6e-4);
    EXPECT_LT(worstIrradiance, 6e-4); // 3e-3 with the cosine of the pixel's centre
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, OffAxisSphere,
    testing::Values(Case{"PointAt35Degrees", 0.05, 35.0}, Case{"SmallAt35Degrees", 0.3, 35.0},
                    Case{"PointSourceAt35Degrees", 0.3, 35.0, 1.0},
                    Case{"PixelAt35Degrees", 1.0, 35.0}, Case{"FewPixelsAt20Degrees", 3.7, 20.0},
                    Case{"FewPixelsAt35Degrees", 3.7, 35.0}, Case{"OnAxis", 0.3, 0.0}),
    [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

TEST(OffAxisPlate, ThatFillsPixelsHasItsRadianceInEach) {
    InteractiveRenderer irsg;
    irsg.scene.settings.bounces = 0;
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(100.0, 32, 64, one)), greyDatabase(emissivity, temperature_K))};
    look(irsg,
         {.range_m = 110.0, .width_px = 64, .height_px = 48, .fieldOfView_rad = radians(90.0)});
    const RadianceImage image = irsg.imageWithReport().image;
    const double expected =
        emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(static_cast<double>(image.at(x, y)) / expected, 1.0, 2e-6)
                << x << ", " << y;
        }
    }
}
