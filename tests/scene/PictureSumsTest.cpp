// The pixels of a picture and the numbers printed beside it are one sum, by whatever way it is
// asked.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/image/ImageIntensity.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};

Environment computedAir(const Band& band) {
    AtmosphereSmartParameters parameters;
    parameters.resolution_per_cm = 15;
    parameters.baseWavelengthMin_um = band.range().min_um;
    parameters.baseWavelengthMax_um = band.range().max_um;
    Environment environment;
    environment.add(std::make_shared<const AtmosphereSmart>(parameters));
    environment.sun.elevation_rad = radians(-90.0);
    return environment;
}

struct Case {
    std::string name;
    double range_m, elevation_deg, altitude_m, fieldOfView_deg;
    int side_px, tileSide_samples;
    Band band;
    bool isFlat; ///< without air
};

void PrintTo(const Case& one, std::ostream* out) {
    *out << one.name;
}

class PictureSums : public testing::TestWithParam<Case> {};

} // namespace

TEST_P(PictureSums, AreItsPixels) {
    const Case& c = GetParam();
    InteractiveRenderer irsg;
    irsg.scene.settings.bounces = 0;
    irsg.scene.settings.tileSide_samples = c.tileSide_samples;
    irsg.scene.environment = c.isFlat ? environmentOf(ConstantAtmosphere{}) : computedAir(c.band);
    irsg.scene.entities = {entityOf(modelOf(boxMesh({4.0, 7.0, 2.0}, std::vector<IrCodes>(6, one))),
                                    greyDatabase(0.9, 320.0))};
    irsg.scene.entities.front().pose.attitude.yaw_rad = 0.7;
    look(irsg, {.range_m = c.range_m,
                .azimuth_rad = 0.3,
                .elevation_rad = radians(c.elevation_deg),
                .width_px = c.side_px,
                .height_px = c.side_px,
                .fieldOfView_rad = radians(c.fieldOfView_deg),
                .band = c.band});
    const double lower_m = standingAltitude_m - c.altitude_m;
    irsg.scene.entities.front().pose.position_m.z -= lower_m;
    irsg.view.viewpoint.position_m.z -= lower_m;

    const RenderedImage seen = irsg.imageWithReport();
    const ObjectRadiometry& printed = seen.report.all;
    ASSERT_GT(printed.intensity_W_sr, 0.0);
    EXPECT_NEAR(contrastIntensity_W_sr(seen.image, seen.image.primary()).value(),
                printed.contrastIntensity_W_sr, 2e-5 * printed.intensity_W_sr);
    const ObjectRadiometry swept = irsg.measure().all;
    EXPECT_NEAR(swept.intensity_W_sr, printed.intensity_W_sr, 1e-6 * printed.intensity_W_sr);
    EXPECT_NEAR(swept.contrastIntensity_W_sr, printed.contrastIntensity_W_sr,
                1e-6 * printed.intensity_W_sr);

    // The lines of a spectrum add up to them, where the air has none that they step over.
    if (!c.isFlat) {
        return;
    }
    const SpectralRange range = c.band.range();
    std::vector<double> at_per_cm;
    constexpr int steps = 400;
    for (int i = 0; i <= steps; ++i) {
        at_per_cm.push_back(1e4 / (range.min_um + i * range.width_um() / steps));
    }
    const IntensitySpectrum spectrum = irsg.measureSpectrum(at_per_cm);
    double sum_W_sr = 0.0;
    for (int i = 0; i <= steps; ++i) {
        sum_W_sr += (i == 0 || i == steps ? 0.5 : 1.0) * range.width_um() / steps *
                    spectrum.contrastIntensity_W_sr_um[static_cast<std::size_t>(i)];
    }
    EXPECT_NEAR(sum_W_sr, printed.contrastIntensity_W_sr, 1e-5 * printed.intensity_W_sr);
}

INSTANTIATE_TEST_SUITE_P(
    Views, PictureSums,
    testing::Values(
        // 170 pixels wide: four samples a pixel are more than the mode's.
        Case{"FillsTheFrame", 300.0, 20.0, 1000.0, 3.0, 200, 64, Band::topHat(3.0, 5.0), true},
        // Rows of the picture are right to half a percent, the object's own to a fiftieth of one.
        Case{"LevelAndFar", 20e3, 0.0, 1000.0, 0.5, 64, 64, Band::topHat(8.0, 12.0), false},
        // The pixels of an object on the horizon hold ground and sky, it stands before one of them.
        Case{"OnTheHorizon", 12e3, 0.0, 12.0, 4.0, 48, 64, Band::topHat(8.0, 12.0), false},
        Case{"AboveTheGround", 1500.0, 10.0, 1000.0, 3.0, 96, 64, Band::topHat(8.0, 12.0), false}),
    [](const auto& info) { return info.param.name; });
