// Reports of the source: what leaves the objects, with no air between and nothing behind.
#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const std::vector<Band> bands{Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0)};

std::vector<RenderReport> measured(InteractiveRenderer& irsg, bool alongRange, bool source) {
    return irsg.begin(Outputs::reports(bands).alongRange(alongRange).withSource(source))
        .get()
        .reports;
}

InteractiveRenderer glazed(const Environment& environment, double range_m) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environment;
    SignatureDatabase database;
    for (const auto& [code, temperature_K, emissivity, transmissivity] :
         {std::tuple{1, 420.0, 0.9, 0.0}, {2, 320.0, 0.5, 0.0}, {3, 300.0, 0.3, 0.6}}) {
        database.temperatures[code] = fixedTemperature(temperature_K);
        database.materials[code] = greyMaterial(emissivity, transmissivity);
    }
    irsg.scene.entities = {entityOf(modelOf(glazedMesh()), database)};
    look(irsg, {.range_m = range_m, .azimuth_rad = 0.7, .elevation_rad = 0.2});
    return irsg;
}

/// Bright air that takes and adds nothing on the way to the sensor.
Environment clearAtmosphere() {
    ConstantAtmosphere air;
    air.sunValue = 3.0;
    air.upValue = 2.0;
    air.downValue = 1.0;
    return environmentOf(air, brightAtmosphere().sun);
}
Environment hazyAtmosphere() {
    ConstantAtmosphere air;
    air.transmittanceValue = 0.4;
    air.pathRadianceValue = 0.9;
    air.backgroundValue = 1.7;
    air.sunValue = 3.0;
    air.upValue = 2.0;
    air.downValue = 1.0;
    return environmentOf(air, brightAtmosphere().sun);
}

} // namespace

TEST(SourceReports, OfABlackPlateIsItsPlanckRadianceWhateverTheAir) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = hazyAtmosphere();
    irsg.scene.entities = {entityOf(modelOf(plateMesh({0, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {1, 1})),
                                    greyDatabase(1.0, 320.0))};
    look(irsg, {.range_m = 3000.0, .fieldOfView_rad = 2e-3});
    const auto reports = measured(irsg, false, true);
    ASSERT_EQ(reports.size(), 4u);
    for (std::size_t k = 0; k < 2; ++k) {
        const double expected = 4.0 * bandRadiance_W_m2_sr(bands[k], 320.0);
        const ObjectRadiometry& source = reports[2 + k].all;
        EXPECT_NEAR(source.intensity_W_sr, expected, 2e-3 * expected);
        EXPECT_EQ(source.contrastIntensity_W_sr, source.intensity_W_sr);
        EXPECT_GT(std::abs(reports[k].all.intensity_W_sr / expected - 1.0), 0.05);
    }
}

TEST(SourceReports, AreThoseOfTheSameLightThroughClearAirBeforeNothing) {
    for (const bool alongRange : {false, true}) {
        InteractiveRenderer hazy = glazed(hazyAtmosphere(), 300.0),
                            clear = glazed(clearAtmosphere(), 300.0);
        RenderSettings settings = RenderSettings::direct();
        settings.background = BackgroundMode::none;
        clear.scene.settings = settings;
        const auto source = measured(hazy, alongRange, true);
        const auto expected = measured(clear, alongRange, false);
        for (std::size_t k = 0; k < 2; ++k) {
            const double intensity = expected[k].all.intensity_W_sr;
            EXPECT_NEAR(source[2 + k].all.intensity_W_sr, intensity, 1e-9 * intensity);
            EXPECT_NEAR(source[2 + k].all.coveredPixels, expected[k].all.coveredPixels, 1e-9);
        }
    }
}

TEST(SourceReports, LeaveThoseOfTheBandsAsTheyAre) {
    for (const BackgroundMode background :
         {BackgroundMode::environment, BackgroundMode::constant, BackgroundMode::none}) {
        InteractiveRenderer with = glazed(hazyAtmosphere(), 300.0),
                            without = glazed(hazyAtmosphere(), 300.0);
        RenderSettings settings = RenderSettings::direct();
        settings.background = background;
        settings.background_W_m2_sr = 0.3;
        with.scene.settings = settings;
        without.scene.settings = settings;
        const auto reports = measured(with, false, true);
        const auto expected = measured(without, false, false);
        ASSERT_EQ(reports.size(), 4u);
        ASSERT_EQ(expected.size(), 2u);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(reports[k].all.intensity_W_sr, expected[k].all.intensity_W_sr);
            EXPECT_EQ(reports[k].all.contrastIntensity_W_sr,
                      expected[k].all.contrastIntensity_W_sr);
            EXPECT_EQ(reports[k].totalIrradiance_W_m2, expected[k].totalIrradiance_W_m2);
            EXPECT_EQ(reports[2 + k].background_W_m2_sr, 0.0);
        }
    }
}
