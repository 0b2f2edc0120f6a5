#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/core/Errors.h"
#include "tests/atmosphere/AerosolSupport.h"

namespace irsg {
namespace {

using namespace aerosoltest;

const std::vector<AerosolModel> allModels = {AerosolModel::rural,        AerosolModel::urban,
                                             AerosolModel::maritime,     AerosolModel::navyMaritime,
                                             AerosolModel::tropospheric, AerosolModel::advectiveFog,
                                             AerosolModel::radiativeFog, AerosolModel::desert};

TEST(Aerosols, TheExtinctionAtTheGroundIsThatOfKoschmieder) {
    for (const AerosolModel model : allModels) {
        for (const double visibility_km :
             {0.05, 0.2, 1.0, 2.0, 5.0, 7.0, 15.0, 23.0, 31.0, 80.0, 300.0}) {
            const auto layers = particleLayers(settings(model, 1e3 * visibility_km), dry);
            const double expected = (3.912 / visibility_km - 0.01159) * 1e-3;
            EXPECT_NEAR(at(layers, 0.0, 0.55).extinction / expected, 1.0, 1e-12)
                << static_cast<int>(model) << " " << visibility_km;
        }
    }
}

TEST(Aerosols, EveryModelHasItsOwnVisibility) {
    const std::vector<std::pair<AerosolModel, double>> own = {
        {AerosolModel::rural, 23.0},       {AerosolModel::urban, 5.0},
        {AerosolModel::maritime, 23.0},    {AerosolModel::tropospheric, 50.0},
        {AerosolModel::advectiveFog, 0.2}, {AerosolModel::radiativeFog, 0.5}};
    for (const auto& [model, visibility_km] : own) {
        EXPECT_NEAR(extinction550At(particleLayers(settings(model), dry), 0.0),
                    (3.912 / visibility_km - 0.01159) * 1e-3, 1e-15);
    }
}

TEST(Aerosols, RuralAirOf23KmScattersAsThePublishedTableSays) {
    const auto layers = particleLayers(settings(AerosolModel::rural), dry);
    const double ground_per_m = (3.912 / 23.0 - 0.01159) * 1e-3;
    EXPECT_NEAR(at(layers, 0.0, 1.06).extinction / ground_per_m, 0.41943, 1e-9);
    EXPECT_NEAR(at(layers, 0.0, 10.0).extinction / ground_per_m, 0.11437, 0.03);
    EXPECT_NEAR(layers.front().opticsAt(1.06).asymmetry, 0.6176, 1e-9);
}

TEST(Aerosols, OpticsAtTheGroundAreThoseOfTheLayers) {
    for (const AerosolModel model : allModels) {
        const ParticleOptics optics = aerosolOptics(model, 0.0, 4.0);
        const auto layers = particleLayers(settings(model), dry);
        EXPECT_NEAR(optics.extinction, layers.front().opticsAt(4.0).extinction, 1e-12);
        EXPECT_NEAR(optics.absorption, layers.front().opticsAt(4.0).absorption, 1e-12);
        EXPECT_NEAR(optics.asymmetry, layers.front().opticsAt(4.0).asymmetry, 1e-12);
    }
    EXPECT_NEAR(aerosolOptics(AerosolModel::rural, 0.8, 3.75).asymmetry, 0.7336, 1e-12);
}

TEST(Aerosols, HumidityIsInterpolatedInTheLogarithmOfTheDeficit) {
    // Half way between ln 30 and ln 20 is ln of the geometric mean.
    const double humidity = 1.0 - std::sqrt(30.0 * 20.0) / 100.0;
    const particles::Optics optics = particles::humidOptics("rural", humidity);
    const ParticleLayer layer{"", {}, {}, optics.wavelengths_um, optics.values};
    EXPECT_NEAR(layer.opticsAt(1.06).extinction, std::sqrt(0.42171 * 0.43228), 1e-9);
    EXPECT_NEAR(layer.opticsAt(1.06).absorption, std::sqrt(0.05335 * 0.04158), 1e-9);
    EXPECT_NEAR(layer.opticsAt(1.06).asymmetry, 0.5 * (0.6314 + 0.665), 1e-9);
    // The ends are the table's and hold beyond.
    const auto driest = particles::humidOptics("rural", -0.1).values;
    EXPECT_NEAR(driest[5].extinction, 0.41943, 1e-12);
    const auto wettest = particles::humidOptics("rural", 1.2).values;
    EXPECT_NEAR(wettest[5].extinction, 0.50595, 1e-12);
}

TEST(Aerosols, APowerLawOfTheWavelengthIsKeptBetweenNodes) {
    ParticleLayer layer{"", {}, {}, {1.0, 4.0}, {{1.0, 0.0, 0.2}, {0.25, 0.1, 0.6}}};
    EXPECT_NEAR(layer.opticsAt(2.0).extinction, 0.5, 1e-12);
    EXPECT_NEAR(layer.opticsAt(2.0).absorption, 0.5 * 0.2, 1e-12);
    EXPECT_NEAR(layer.opticsAt(2.0).asymmetry, 0.4, 1e-12);
    EXPECT_EQ(layer.opticsAt(0.1).extinction, 1.0);
    EXPECT_EQ(layer.opticsAt(100.0).extinction, 0.25);
}

TEST(Aerosols, TheNavyFormulaGivesThePublishedExtinction) {
    EXPECT_NEAR(particles::navyMaritime(3, 6.9, 6.9, 0.8).extinction550_per_m, 0.087e-3, 0.0005e-3);
}

TEST(Aerosols, SeaAndDesertRaiseMoreAerosolInMoreWind) {
    for (const AerosolModel model : {AerosolModel::navyMaritime, AerosolModel::desert}) {
        double before = 0.0;
        for (const double wind : {0.1, 5.0, 12.0, 18.0}) {
            ParticleSettings wanted = settings(model);
            wanted.windSpeed_m_s = wanted.windSpeed24h_m_s = wind;
            const double now = extinction550At(particleLayers(wanted, dry), 0.0);
            EXPECT_GT(now, before);
            before = now;
        }
    }
}

TEST(Aerosols, TheDesertIsThatOfTheTableAtItsWinds) {
    EXPECT_NEAR(particles::desert(10.0).extinction550_per_m, 0.057144e-3, 1e-9);
    EXPECT_NEAR(particles::desert(30.0).extinction550_per_m, 1.9488e-3, 1e-9);
    EXPECT_NEAR(particles::desert(15.0).extinction550_per_m, 1e-3 * std::sqrt(0.057144 * 0.22773),
                1e-9);
}

TEST(Aerosols, TheWindIsBroughtTo10mByTheLogarithmicLaw) {
    EXPECT_NEAR(particles::windAt10m(7.0, 10.0, particles::seaRoughness_m), 7.0, 1e-12);
    EXPECT_NEAR(particles::windAt10m(7.0, 2.0, particles::seaRoughness_m),
                7.0 * std::log(5e4) / std::log(1e4), 1e-12);
    // The same wind told at another height makes the same aerosol.
    ParticleSettings low = settings(AerosolModel::navyMaritime);
    low.windHeight_m = 2.0;
    ParticleSettings high = low;
    high.windHeight_m = 10.0;
    high.windSpeed_m_s = high.windSpeed24h_m_s =
        particles::windAt10m(5.0, 2.0, particles::seaRoughness_m);
    EXPECT_NEAR(extinction550At(particleLayers(low, dry), 0.0),
                extinction550At(particleLayers(high, dry), 0.0), 1e-15);
}

TEST(Aerosols, OpticsArePossibleAtEveryWavelength) {
    for (const AerosolModel model : allModels) {
        for (const double humidity : {0.0, 0.5, 0.77, 0.99, 1.0}) {
            for (const ParticleLayer& layer :
                 particleLayers(settings(model), [=](double) { return humidity; })) {
                for (double um = 0.15; um < 60.0; um *= 1.01) {
                    const ParticleOptics optics = layer.opticsAt(um);
                    ASSERT_GT(optics.extinction, 0.0) << layer.name << " " << um;
                    ASSERT_GE(optics.absorption, 0.0) << layer.name << " " << um;
                    ASSERT_LE(optics.absorption, optics.extinction) << layer.name << " " << um;
                    ASSERT_GE(optics.asymmetry, 0.0) << layer.name << " " << um;
                    ASSERT_LT(optics.asymmetry, 1.0) << layer.name << " " << um;
                }
            }
        }
    }
}

TEST(Aerosols, TheExtinctionIsContinuousInAltitude) {
    for (const AerosolModel model : allModels) {
        const auto layers = particleLayers(settings(model), humidityOf("us76"));
        for (double z = 0.0; z < 99e3; z += 50.0) {
            const double a = at(layers, z, 4.0).extinction;
            const double b = at(layers, z + 1e-6, 4.0).extinction;
            ASSERT_NEAR(a, b, 1e-7 * a + 1e-14) << z;
            ASSERT_GT(a, 0.0) << z;
        }
    }
}

TEST(Aerosols, TheExtinctionIsContinuousInVisibility) {
    for (const double km : {2.0, 5.0, 10.0, 23.0, 50.0}) {
        for (const double z : {0.0, 700.0, 1500.0, 2500.0, 3500.0}) {
            const double below = extinction550At(
                particleLayers(settings(AerosolModel::rural, 1e3 * km - 0.01), dry), z);
            const double above = extinction550At(
                particleLayers(settings(AerosolModel::rural, 1e3 * km + 0.01), dry), z);
            EXPECT_NEAR(above / below, 1.0, 1e-4) << km << " " << z;
            EXPECT_LE(above, below * (1.0 + 1e-6)) << km << " " << z;
        }
    }
}

TEST(Aerosols, TheSeasonChangesOnlyWhatLiesAboveTheBoundaryLayer) {
    ParticleSettings wanted = settings(AerosolModel::rural);
    const auto summer = particleLayers(wanted, dry);
    wanted.winter = true;
    const auto winter = particleLayers(wanted, dry);
    for (const double z : {0.0, 500.0, 1500.0, 2000.0, 40e3}) {
        EXPECT_EQ(extinction550At(summer, z), extinction550At(winter, z));
    }
    EXPECT_NEAR(extinction550At(winter, 3000.0) * 1e3, 0.0272, 1e-6);
    EXPECT_NEAR(extinction550At(summer, 3000.0) * 1e3, 0.0346, 1e-6);
    EXPECT_NEAR(extinction550At(winter, 16e3) * 1e3, 0.000641, 1e-9);
}

TEST(Aerosols, HumidityThatIsNoNumberIsAProgrammingError) {
    for (const AerosolModel model : {AerosolModel::rural, AerosolModel::navyMaritime}) {
        EXPECT_THROW(particleLayers(settings(model), [](double) { return std::nan(""); }),
                     LogicError);
    }
}

TEST(Aerosols, NothingFloatsInAirWithoutAerosol) {
    ParticleSettings none;
    none.aerosol.reset();
    EXPECT_TRUE(particleLayers(none, dry).empty());
}

TEST(Aerosols, TheSumDoesNotDependOnTheOrderOfTheLayers) {
    auto layers = particleLayers(settings(AerosolModel::maritime), humidityOf("tropical"));
    const ParticleOptics before = depth(layers, 0.0, 20e3, 9.5);
    std::reverse(layers.begin(), layers.end());
    EXPECT_NEAR(depth(layers, 0.0, 20e3, 9.5).extinction / before.extinction, 1.0, 1e-12);
}

} // namespace
} // namespace irsg
