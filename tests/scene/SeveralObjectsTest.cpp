#include <gtest/gtest.h>

#include "irsg/radiance/ScaledView.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr double emissivity = 0.9, temperature_K = 320.0, apart_m = 800.0;

/// Two grey spheres of radius 1 m without air: one at the reference point, the other 12 m aside and
/// 800 m nearer to a camera ahead.
class TwoSpheres : public testing::Test {
  protected:
    void SetUp() override {
        irsg.scene.environment = environmentOf(ConstantAtmosphere{});
        Entity far = entityOf(modelOf(sphereMesh(1.0, 48, 96, {1, 1})),
                              greyDatabase(emissivity, temperature_K));
        Entity near = far;
        far.name = "far";
        near.name = "near";
        near.pose.position_m = {12.0, apart_m, standingAltitude_m};
        irsg.scene.entities = {far, near};
    }
    void lookFrom(double range_m) {
        look(irsg, {.range_m = range_m, .width_px = 320, .height_px = 200, .fieldOfView_rad = 0.4});
        irsg.scene.entities[1].pose = {{12.0, apart_m, standingAltitude_m}, {}};
    }
    /// Of one sphere, at its own range, as far as its facets are one.
    static double intensity_W_sr() {
        return pi * emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
    }
    void expectBoth(const RenderReport& report, double range_m) const {
        ASSERT_EQ(report.objects.size(), 2u);
        EXPECT_NEAR(report.objects[1].range_m, range_m - apart_m, 0.5);
        for (const ObjectRadiometry& object : report.objects) {
            EXPECT_NEAR(object.intensity_W_sr / intensity_W_sr(), 1.0, 5e-3) << object.name;
        }
        EXPECT_NEAR(report.all.intensity_W_sr / (2.0 * intensity_W_sr()), 1.0, 5e-3);
        EXPECT_NEAR(report.all.contrastIntensity_W_sr / (report.objects[0].contrastIntensity_W_sr +
                                                         report.objects[1].contrastIntensity_W_sr),
                    1.0, 1e-12);
        EXPECT_NEAR(report.all.irradiance_W_m2 /
                        (report.objects[0].irradiance_W_m2 + report.objects[1].irradiance_W_m2),
                    1.0, 1e-5);
    }

    InteractiveRenderer irsg{RenderSettings::direct()};
};

} // namespace

TEST_F(TwoSpheres, HaveTheSumOfTheirIntensitiesAtEveryRange) {
    for (const double range_m : {1000.0, 2000.0}) {
        SCOPED_TRACE(range_m);
        lookFrom(range_m);
        expectBoth(irsg.measure(), range_m);
        expectBoth(irsg.imageWithReport().report, range_m);
    }
}

TEST_F(TwoSpheres, HaveSpectraOfTheirOwnWhoseSumIsThatOfTheScene) {
    lookFrom(1000.0);
    const IntensitySpectrum spectrum = irsg.measureSpectrum({2500.0, 2000.0});
    ASSERT_EQ(spectrum.objects.size(), 2u);
    EXPECT_EQ(spectrum.objects[1].name, "near");
    for (std::size_t i = 0; i < 2; ++i) {
        const double expected =
            pi * emissivity * planckRadiance_W_m2_sr_um(spectrum.wavelengths_um[i], temperature_K);
        double sum = 0.0, irradiance = 0.0;
        for (const ObjectSpectrum& object : spectrum.objects) {
            EXPECT_NEAR(object.intensity_W_sr_um[i] / expected, 1.0, 5e-3) << object.name;
            EXPECT_EQ(object.contrastIntensity_W_sr_um[i], object.intensity_W_sr_um[i]);
            sum += object.intensity_W_sr_um[i];
            irradiance += object.irradiance_W_m2_um[i];
        }
        EXPECT_NEAR(spectrum.intensity_W_sr_um[i] / sum, 1.0, 1e-12);
        EXPECT_NEAR(spectrum.irradiance_W_m2_um[i] / irradiance, 1.0, 1e-12);
    }
}

TEST_F(TwoSpheres, AreScaledEachAtItsOwnRange) {
    lookFrom(1000.0);
    // The near one alone, scaled to nothing and to a tenth more.
    const std::vector<ScalingInput> inputs = {{1, ScalingKind::emissivity, 1, 0.0, 1.1}};
    const auto inBand = irsg.scaledView(inputs);
    const auto spectral = irsg.scaledSpectrum(inputs, {2500.0});
    const RenderReport report = irsg.measure();
    const IntensitySpectrum spectrum = irsg.measureSpectrum({2500.0});
    ScaledValues values;
    inBand->evaluate(std::vector<double>{0.0}, values);
    EXPECT_NEAR(values.intensity[0] / report.objects[0].intensity_W_sr, 1.0, 1e-9);
    inBand->evaluate(std::vector<double>{1.1}, values);
    EXPECT_NEAR(values.intensity[0] /
                    (report.objects[0].intensity_W_sr + 1.1 * report.objects[1].intensity_W_sr),
                1.0, 1e-9);
    spectral->evaluate(std::vector<double>{0.0}, values);
    EXPECT_NEAR(values.intensity[0] / spectrum.objects[0].intensity_W_sr_um[0], 1.0, 1e-9);
}

TEST(OneObject, IsTheSceneAndHasNoSpectrumBesideIt) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 32, 64, {1, 1})), greyDatabase(0.9, 320.0))};
    look(irsg, {.range_m = 100.0});
    const RenderReport report = irsg.measure();
    EXPECT_EQ(report.all.intensity_W_sr, report.objects.at(0).intensity_W_sr);
    EXPECT_TRUE(irsg.measureSpectrum({2500.0}).objects.empty());
}
