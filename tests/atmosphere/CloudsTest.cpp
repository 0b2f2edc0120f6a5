#include <cmath>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/core/Errors.h"

namespace irsg {
namespace {

double dry(double) {
    return 0.5;
}

ParticleSettings cloud(int model) {
    ParticleSettings result;
    result.aerosol.reset();
    result.cloudModel = model;
    return result;
}

std::vector<ParticleLayer> layersOf(const ParticleSettings& settings) {
    return particleLayers(settings, dry);
}

double column(const ParticleLayer& layer) {
    double sum = 0.0;
    for (std::size_t i = 1; i < layer.altitudes_m.size(); ++i) {
        sum += 0.5 * (layer.extinction550_per_m[i] + layer.extinction550_per_m[i - 1]) *
               (layer.altitudes_m[i] - layer.altitudes_m[i - 1]);
    }
    return sum;
}

struct Own {
    int model;
    double base_m, thickness_m;
    std::size_t layers;
};
const std::vector<Own> own = {{1, 660, 2340, 1},  {2, 2400, 600, 1},    {3, 330, 670, 1},
                              {4, 660, 1340, 1},  {5, 160, 500, 1},     {6, 330, 670, 2},
                              {7, 160, 500, 2},   {8, 160, 500, 2},     {9, 660, 2340, 2},
                              {10, 660, 2340, 2}, {18, 10000, 1000, 1}, {19, 10000, 200, 1}};

TEST(Clouds, LieWhereTheModelsSay) {
    for (const Own& row : own) {
        const particles::CloudPlace place = particles::cloudPlace(cloud(row.model));
        EXPECT_NEAR(place.base_m, row.base_m, 1e-9) << row.model;
        EXPECT_NEAR(place.thickness_m, row.thickness_m, 1e-9) << row.model;
        EXPECT_EQ(layersOf(cloud(row.model)).size(), row.layers) << row.model;
    }
    EXPECT_TRUE(layersOf(cloud(0)).empty());
}

TEST(Clouds, StandardCirrusHasAnOpticalDepthOf014ForOneKilometre) {
    EXPECT_NEAR(column(layersOf(cloud(18)).front()), 0.14, 1e-12);
    EXPECT_NEAR(column(layersOf(cloud(19)).front()), 0.14 * 0.2 * 0.2, 1e-12);
}

TEST(Clouds, CirrusLieLowerInColdAir) {
    const std::vector<std::pair<ModelAtmosphere, double>> bases = {
        {ModelAtmosphere::tropical, 11e3},         {ModelAtmosphere::midlatitudeSummer, 10e3},
        {ModelAtmosphere::midlatitudeWinter, 8e3}, {ModelAtmosphere::subarcticSummer, 7e3},
        {ModelAtmosphere::subarcticWinter, 5e3},   {ModelAtmosphere::usStandard1976, 10e3}};
    for (const auto& [atmosphere, base_m] : bases) {
        ParticleSettings wanted = cloud(18);
        wanted.atmosphere = atmosphere;
        EXPECT_EQ(particles::cloudPlace(wanted).base_m, base_m);
    }
}

TEST(Clouds, CumulusIsAsDenseAsItsWaterContent) {
    // 1 g m-3 at 0.007683 g m-3 per km-1.
    EXPECT_NEAR(layersOf(cloud(1)).front().extinction550At(1500.0), 1e-3 / 0.007683, 1e-8);
    EXPECT_NEAR(layersOf(cloud(3)).front().extinction550At(660.0), 0.3e-3 / 0.005272, 1e-8);
}

TEST(Clouds, HaveTheOpticalDepthOfTheirWater) {
    const std::vector<std::pair<int, double>> depths = {
        {1, 208.5}, {2, 47.4}, {3, 29.0}, {4, 43.7}, {5, 34.3}};
    for (const auto& [model, depth] : depths) {
        EXPECT_NEAR(column(layersOf(cloud(model)).front()), depth, 0.06) << model;
    }
}

TEST(Clouds, TheOpticalDepthIsTheVerticalExtinctionTimesTheThickness) {
    for (const Own& row : own) {
        ParticleSettings wanted = cloud(row.model);
        wanted.cloudExtinction_per_m = 0.02;
        EXPECT_NEAR(column(layersOf(wanted).front()), 0.02 * row.thickness_m, 1e-9) << row.model;
        wanted.cloudThickness_m = 321.0;
        wanted.cloudBase_m = 0.0;
        EXPECT_NEAR(column(layersOf(wanted).front()), 0.02 * 321.0, 1e-9) << row.model;
    }
}

TEST(Clouds, MoveWithTheirBaseAndStretchWithTheirThickness) {
    for (const int model : {1, 2, 3, 4, 5}) {
        const ParticleLayer still = layersOf(cloud(model)).front();
        ParticleSettings moved = cloud(model);
        const particles::CloudPlace place = particles::cloudPlace(moved);
        moved.cloudBase_m = place.ownBase_m + 1000.0;
        moved.cloudThickness_m = 2.0 * place.ownThickness_m;
        const ParticleLayer other = layersOf(moved).front();
        for (const double part : {0.0, 0.2, 0.5, 0.77, 1.0}) {
            EXPECT_NEAR(other.extinction550At(moved.cloudBase_m + part * moved.cloudThickness_m),
                        still.extinction550At(place.ownBase_m + part * place.ownThickness_m),
                        1e-12);
        }
        EXPECT_NEAR(column(other) / column(still), 2.0, 1e-9);
    }
}

TEST(Clouds, EndInsideTheirEdges) {
    for (const Own& row : own) {
        const ParticleLayer layer = layersOf(cloud(row.model)).front();
        EXPECT_EQ(layer.extinction550_per_m.front(), 0.0);
        EXPECT_EQ(layer.extinction550_per_m.back(), 0.0);
        EXPECT_GT(layer.extinction550At(row.base_m), 0.0);
        EXPECT_EQ(layer.extinction550At(row.base_m - 0.11 * row.thickness_m), 0.0);
        EXPECT_EQ(layer.extinction550At(row.base_m + 1.11 * row.thickness_m), 0.0);
        for (std::size_t i = 1; i < layer.altitudes_m.size(); ++i) {
            EXPECT_LT(layer.altitudes_m[i - 1], layer.altitudes_m[i]);
        }
    }
}

TEST(Clouds, OpticsArePossibleAtEveryWavelength) {
    for (const Own& row : own) {
        for (const ParticleLayer& layer : layersOf(cloud(row.model))) {
            for (double um = 0.15; um < 60.0; um *= 1.01) {
                const ParticleOptics optics = layer.opticsAt(um);
                ASSERT_GT(optics.extinction, 0.0);
                ASSERT_GE(optics.absorption, 0.0);
                ASSERT_LE(optics.absorption, optics.extinction);
                ASSERT_GE(optics.asymmetry, 0.0);
                ASSERT_LT(optics.asymmetry, 1.0);
            }
        }
    }
}

TEST(Clouds, RainIsThatOfMarshallAndPalmer) {
    const std::vector<std::pair<int, double>> atGround = {
        {6, 0.564335}, {7, 1.00517}, {8, 1.79037}, {9, 2.77071}, {10, 5.53576}};
    for (const auto& [model, extinction_per_km] : atGround) {
        const ParticleLayer rain = layersOf(cloud(model)).back();
        EXPECT_EQ(rain.name, "rain");
        EXPECT_NEAR(rain.extinction550At(0.0) * 1e3 / extinction_per_km, 1.0, 1e-4) << model;
        EXPECT_EQ(rain.opticsAt(10.0).absorption, 0.5);
        EXPECT_EQ(rain.opticsAt(4.0).asymmetry, 0.85);
        EXPECT_EQ(rain.opticsAt(1.0).extinction, 1.0);
    }
}

TEST(Clouds, RainFallsFromItsCloudToTheGroundWhereverTheCloudIs) {
    for (const double base_m : {0.0, 500.0, 3000.0}) {
        ParticleSettings wanted = cloud(9);
        wanted.cloudBase_m = base_m;
        wanted.cloudThickness_m = 1000.0;
        const ParticleLayer rain = layersOf(wanted).back();
        EXPECT_NEAR(rain.extinction550At(0.0) * 1e3, 2.77071, 1e-3);
        double before = 1.0;
        for (double z = 0.0; z < base_m + 1000.0; z += 25.0) {
            EXPECT_GT(rain.extinction550At(z), 0.0) << z;
            EXPECT_LE(rain.extinction550At(z), before) << z;
            before = rain.extinction550At(z);
        }
        EXPECT_EQ(rain.extinction550At(base_m + 1021.0), 0.0);
    }
}

TEST(Clouds, RainStretchesWithTheGapBelowItsCloud) {
    // Half way up to the base the table has 17.5 mm/h at 330 m.
    ParticleSettings wanted = cloud(9);
    wanted.cloudBase_m = 3000.0;
    EXPECT_NEAR(layersOf(wanted).back().extinction550At(1500.0), 0.36467e-3 * std::pow(17.5, 0.63),
                1e-9);
}

TEST(Clouds, DoNotChangeTheAerosolTheyFloatIn) {
    ParticleSettings with = cloud(3);
    with.aerosol = AerosolModel::urban;
    ParticleSettings without = with;
    without.cloudModel = 0;
    const auto both = layersOf(with);
    const auto haze = layersOf(without);
    ASSERT_EQ(both.size(), haze.size() + 1);
    for (std::size_t i = 0; i < haze.size(); ++i) {
        EXPECT_EQ(both[i].extinction550_per_m, haze[i].extinction550_per_m);
    }
}

struct BadSettings {
    const char* name;
    const char* parameter;
    void (*spoil)(ParticleSettings&);
};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
using S = ParticleSettings;

const std::vector<BadSettings> badSettings = {
    {"aerosol below", "AerosolModel", [](S& s) { s.aerosol = static_cast<AerosolModel>(-1); }},
    {"aerosol above", "AerosolModel", [](S& s) { s.aerosol = static_cast<AerosolModel>(8); }},
    {"visibility negative", "Visibility", [](S& s) { s.visibility_m = -1.0; }},
    {"visibility of a hand", "Visibility", [](S& s) { s.visibility_m = 0.2; }},
    {"visibility beyond Rayleigh", "Visibility", [](S& s) { s.visibility_m = 338e3; }},
    {"visibility nan", "Visibility", [](S& s) { s.visibility_m = nan; }},
    {"visibility without aerosol", "Visibility",
     [](S& s) {
         s.aerosol.reset();
         s.visibility_m = 5e3;
     }},
    {"air mass 0", "AirMass", [](S& s) { s.airMass = 0; }},
    {"air mass 11", "AirMass", [](S& s) { s.airMass = 11; }},
    {"calm", "WindSpeed", [](S& s) { s.windSpeed_m_s = 0.0; }},
    {"hurricane", "WindSpeed", [](S& s) { s.windSpeed_m_s = 30.1; }},
    {"wind nan", "WindSpeed", [](S& s) { s.windSpeed_m_s = nan; }},
    {"calm day", "WindSpeedAverage24", [](S& s) { s.windSpeed24h_m_s = 0.05; }},
    {"stormy day", "WindSpeedAverage24", [](S& s) { s.windSpeed24h_m_s = 31.0; }},
    {"low anemometer", "WindSpeedMeasurementHeight", [](S& s) { s.windHeight_m = 1.9; }},
    {"high anemometer", "WindSpeedMeasurementHeight", [](S& s) { s.windHeight_m = 41.0; }},
    {"cloud 11", "CloudModel", [](S& s) { s.cloudModel = 11; }},
    {"cloud 17", "CloudModel", [](S& s) { s.cloudModel = 17; }},
    {"cloud 20", "CloudModel", [](S& s) { s.cloudModel = 20; }},
    {"cloud below", "CloudModel", [](S& s) { s.cloudModel = -1; }},
    {"base in space", "CloudBaseAltitude",
     [](S& s) {
         s.cloudModel = 1;
         s.cloudBase_m = 20001.0;
     }},
    {"base infinite", "CloudBaseAltitude",
     [](S& s) {
         s.cloudModel = 1;
         s.cloudBase_m = -inf;
     }},
    {"top too high", "CloudThickness",
     [](S& s) {
         s.cloudModel = 18;
         s.cloudThickness_m = 10001.0;
     }},
    {"thickness of a step", "CloudThickness",
     [](S& s) {
         s.cloudModel = 1;
         s.cloudThickness_m = 0.5;
     }},
    {"extinction in km-1", "CloudExtinction",
     [](S& s) {
         s.cloudModel = 1;
         s.cloudExtinction_per_m = 60.0;
     }},
    {"extinction nan", "CloudExtinction",
     [](S& s) {
         s.cloudModel = 1;
         s.cloudExtinction_per_m = nan;
     }},
    {"base of no cloud", "CloudBaseAltitude", [](S& s) { s.cloudBase_m = 500.0; }},
    {"thickness of no cloud", "CloudThickness", [](S& s) { s.cloudThickness_m = 500.0; }},
    {"extinction of no cloud", "CloudExtinction", [](S& s) { s.cloudExtinction_per_m = 0.01; }},
    {"atmosphere 7", "AtmosphereModel",
     [](S& s) { s.atmosphere = static_cast<ModelAtmosphere>(7); }}};

TEST(ParticleSettings, EachThatIsOutOfRangeIsNamed) {
    for (const BadSettings& bad : badSettings) {
        ParticleSettings settings;
        bad.spoil(settings);
        try {
            particleLayers(settings, dry);
            ADD_FAILURE() << bad.name << " was accepted";
        } catch (const InputError& error) {
            ASSERT_EQ(error.diagnostics().size(), 1u) << bad.name << ": " << error.what();
            EXPECT_EQ(error.diagnostics().front().position, bad.parameter) << bad.name;
            EXPECT_FALSE(error.diagnostics().front().expected.empty()) << bad.name;
        }
    }
}

TEST(ParticleSettings, AllDiagnosticsComeAtOnce) {
    ParticleSettings settings;
    settings.visibility_m = -3.0;
    settings.airMass = 0;
    settings.windSpeed_m_s = 99.0;
    settings.cloudModel = 12;
    try {
        particleLayers(settings, dry);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 4u);
        EXPECT_THAT(error.what(), testing::HasSubstr("AirMass"));
    }
}

TEST(ParticleSettings, TheEndsOfTheRangesAreAccepted) {
    ParticleSettings settings;
    settings.aerosol = AerosolModel::navyMaritime;
    settings.airMass = 10;
    settings.windSpeed_m_s = 30.0;
    settings.windSpeed24h_m_s = 0.1;
    settings.windHeight_m = 2.0;
    settings.visibility_m = 10.0;
    settings.cloudModel = 19;
    settings.cloudBase_m = 19000.0;
    settings.cloudThickness_m = 1000.0;
    settings.cloudExtinction_per_m = 1.0;
    EXPECT_NO_THROW(particleLayers(settings, dry));
}

} // namespace
} // namespace irsg
