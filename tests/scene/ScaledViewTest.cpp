#include "irsg/radiance/ScaledView.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/random/Philox.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

/// Windows that do not follow the temperatures, so that only scales differ.
RenderSettings settingsOfTests() {
    RenderSettings settings = RenderSettings::direct();
    settings.hotSpots = false;
    return settings;
}

InteractiveRenderer& generator() {
    static InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.settings = settingsOfTests();
    return irsg;
}

/// A sphere inside a transparent box: paint and hot metal, gas with a spectrum of its own.
Entity glazedSphere() {
    SignatureDatabase database;
    database.temperatures[1] = fixedTemperature(300.0);
    database.temperatures[2] = fixedTemperature(600.0);
    database.temperatures[3] = fixedTemperature(290.0);
    database.temperatures[3].mode = EmissionMode::userSpectrum;
    database.temperatures[3].userSpectrum = "gas";
    database.spectra["gas"] = {
        "gas", 0.0, "", "", {{"all", Spectrum({2.0, 4.0, 15.0}, {0.1, 0.9, 0.2})}}};
    database.materials[1] = greyMaterial(0.6);
    database.materials[2].emissivity = Spectrum({2.0, 4.0, 15.0}, {0.5, 0.97, 0.7});
    database.materials[2].transmissivity = Spectrum::constant(0.0);
    database.materials[3] = greyMaterial(0.3, 0.6);
    return entityOf(modelOf(glazedMesh()), std::move(database));
}

const std::vector<ScalingInput> inputs{
    {0, ScalingKind::temperature, 1, 0.8, 1.2}, {0, ScalingKind::temperature, 2, 0.9, 1.5},
    {0, ScalingKind::temperature, 3, 0.5, 2.0}, {0, ScalingKind::emissivity, 1, 0.5, 1.4},
    {0, ScalingKind::emissivity, 2, 0.2, 1.0},  {0, ScalingKind::emissivity, 3, 0.4, 3.0},
    {0, ScalingKind::emissivity, 77, 0.4, 3.0}};

std::vector<double> draw(std::uint64_t number) {
    std::vector<double> scales;
    for (const ScalingInput& input : inputs) {
        scales.push_back(
            input.least +
            (input.most - input.least) *
                unitOf(1, {static_cast<std::uint32_t>(input.kind), 0, input.index}, number));
    }
    return scales;
}

Entity scaled(Entity entity, const std::vector<double>& scales) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        (inputs[i].kind == ScalingKind::temperature ? entity.temperatureScale
                                                    : entity.emissivityScale)[inputs[i].index] =
            scales[i];
    }
    return entity;
}

} // namespace

TEST(ScaledView, SaysWhatTheRendererSaysOfAScaledScene) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = brightAtmosphere();
    for (const Band& band : {Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0)}) {
        irsg.scene.entities = {glazedSphere()};
        look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5, .elevation_rad = 0.2, .band = band});
        const auto view = irsg.scaledView(inputs);
        ASSERT_EQ(view->size(), 1u);
        for (std::uint64_t number = 0; number < 6; ++number) {
            const std::vector<double> scales = draw(number);
            ScaledValues found;
            view->evaluate(scales, found);
            irsg.scene.entities = {scaled(glazedSphere(), scales)};
            const ObjectRadiometry expected = irsg.measure().all;
            // The quadrature follows the coldest surface, which a scale may change.
            EXPECT_NEAR(found.intensity[0] / expected.intensity_W_sr, 1.0, 2e-6) << number;
            EXPECT_NEAR(found.contrastIntensity[0], expected.contrastIntensity_W_sr,
                        2e-6 * expected.intensity_W_sr)
                << number;
            EXPECT_NEAR(found.irradiance[0] * 1e4, expected.irradiance_W_m2 * 1e4,
                        2e-6 * expected.intensity_W_sr)
                << number;
        }
    }
}

TEST(ScaledView, StaysNearTheRendererWhereAScaledSpectrumIsCutInsideTheBand) {
    // Where the scaled emissivity meets 1 - t between two nodes of the quadrature it has a kink
    // there that neither of the two knows of: what remains is the quadrature's error, not physics
    // (spectra agree wavelength by wavelength).
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {glazedSphere()};
    look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5, .elevation_rad = 0.2});
    std::vector<ScalingInput> wider = inputs;
    wider[4].most = 1.3;
    const auto view = irsg.scaledView(wider);
    std::vector<double> scales(inputs.size(), 1.0);
    for (const double cut : {1.05, 1.15, 1.25}) {
        scales[4] = cut;
        ScaledValues found;
        view->evaluate(scales, found);
        irsg.scene.entities = {scaled(glazedSphere(), scales)};
        EXPECT_NEAR(found.intensity[0] / irsg.measure().all.intensity_W_sr, 1.0, 5e-4) << cut;
    }
}

TEST(ScaledView, IsTheUnscaledSceneAtScalesOfOne) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {glazedSphere()};
    look(irsg, {.range_m = 100.0});
    ScaledValues found;
    irsg.scaledView(inputs)->evaluate(std::vector<double>(inputs.size(), 1.0), found);
    const ObjectRadiometry expected = irsg.measure().all;
    EXPECT_NEAR(found.intensity[0] / expected.intensity_W_sr, 1.0, 1e-10);
    EXPECT_NEAR(found.contrastIntensity[0] / expected.contrastIntensity_W_sr, 1.0, 1e-9);
    EXPECT_NEAR(found.irradiance[0] / expected.irradiance_W_m2, 1.0, 1e-9);
}

TEST(ScaledView, ScalesSpectraWavelengthByWavelength) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = brightAtmosphere();
    irsg.scene.entities = {glazedSphere()};
    look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5});
    // In any order, and one of them twice.
    const std::vector<double> wavenumbers{2500.0, 2000.0, 2200.0, 2500.0, 3300.0};
    const auto view = irsg.scaledSpectrum(inputs, wavenumbers);
    ASSERT_EQ(view->size(), wavenumbers.size());
    for (std::uint64_t number = 0; number < 3; ++number) {
        const std::vector<double> scales = draw(number);
        ScaledValues found;
        view->evaluate(scales, found);
        irsg.scene.entities = {scaled(glazedSphere(), scales)};
        const IntensitySpectrum expected = irsg.measureSpectrum(wavenumbers);
        for (std::size_t i = 0; i < wavenumbers.size(); ++i) {
            EXPECT_NEAR(found.intensity[i] / expected.intensity_W_sr_um[i], 1.0, 1e-10);
            EXPECT_NEAR(found.contrastIntensity[i] / expected.contrastIntensity_W_sr_um[i], 1.0,
                        1e-9);
            EXPECT_NEAR(found.irradiance[i] / expected.irradiance_W_m2_um[i], 1.0, 1e-9);
        }
    }
}

TEST(Scalings, KeepEmissivityAndReflectivityAndTransmissivityAtOne) {
    // In an enclosure whose fluxes are those of a black body at the surface's own temperature a
    // surface looks the same whatever its emissivity, if and only if the three add up to 1. In a
    // narrow band Planck's law is a number.
    const double wavelength_um = 10.0, temperature_K = 300.0;
    const double black = planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
    ConstantAtmosphere air;
    air.upValue = air.downValue = pi * black;
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(air);
    const Band band = Band::topHat(wavelength_um - 1e-4, wavelength_um + 1e-4);
    double first = 0.0;
    for (const double scale : {1.0, 0.0, 0.3, 1.25, 4.0}) {
        Entity sphere =
            entityOf(modelOf(sphereMesh(1.0, 32, 64, {1, 1})), greyDatabase(0.8, temperature_K));
        sphere.emissivityScale[1] = scale;
        irsg.scene.entities = {sphere};
        look(irsg, {.range_m = 100.0, .band = band});
        const double intensity = irsg.measure().all.intensity_W_sr;
        first = first == 0.0 ? intensity : first;
        EXPECT_NEAR(intensity / first, 1.0, 1e-5) << scale;
    }
}

TEST(Scalings, NeverEmitMoreThanABlackBody) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    const auto intensityOf = [&](double emissivity, double scale) {
        Entity sphere =
            entityOf(modelOf(sphereMesh(1.0, 32, 64, {1, 1})), greyDatabase(emissivity, 320.0));
        sphere.emissivityScale[1] = scale;
        irsg.scene.entities = {sphere};
        look(irsg, {.range_m = 100.0});
        return irsg.measure().all.intensity_W_sr;
    };
    EXPECT_NEAR(intensityOf(0.9, 5.0), intensityOf(1.0, 1.0), 1e-9);
    EXPECT_NEAR(intensityOf(0.9, 0.5) / intensityOf(0.45, 1.0), 1.0, 1e-12);
}

TEST(Scalings, MultiplyTheTemperatureInKelvinAndTheEmissionOfASpectrumOnlyByEmissivity) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    const auto intensityOf = [&](Entity entity, double temperature, double emissivity) {
        entity.temperatureScale[1] = temperature;
        entity.emissivityScale[1] = emissivity;
        irsg.scene.entities = {entity};
        look(irsg, {.range_m = 100.0});
        return irsg.measure().all.intensity_W_sr;
    };
    const Entity grey =
        entityOf(modelOf(sphereMesh(1.0, 32, 64, {1, 1})), greyDatabase(0.5, 300.0));
    const Entity hotter = entityOf(grey.model, greyDatabase(0.5, 330.0));
    EXPECT_NEAR(intensityOf(grey, 1.1, 1.0) / intensityOf(hotter, 1.0, 1.0), 1.0, 1e-6);

    SignatureDatabase database = greyDatabase(0.5, 300.0);
    database.temperatures[1].mode = EmissionMode::userSpectrum;
    database.temperatures[1].userSpectrum = "lamp";
    database.spectra["lamp"] = {"lamp", 0.0, "", "", {{"all", Spectrum({2.0, 15.0}, {1.0, 1.0})}}};
    const Entity lamp = entityOf(grey.model, std::move(database));
    const double one = intensityOf(lamp, 1.0, 1.0);
    EXPECT_EQ(intensityOf(lamp, 1.5, 1.0), one);
    EXPECT_NEAR(intensityOf(lamp, 1.0, 1.7) / one, 1.7, 1e-12);
}
